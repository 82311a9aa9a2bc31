// emission: light of its own that no lamp is needed for, as a number and as a colour.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.25, 0.35, 0.5> }
camera { location <0, 0.4, -9> look_at <0, 0.4, 0> right x*4/3 angle 40 }
light_source { <-6, 6, -9>, rgb 0.9 }
light_source { <5, 1, -6>, rgb <0.2, 0.25, 0.35> }
plane { y, -1.1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
plane { z, 6 pigment { checker rgb <0.7, 0.75, 0.9>, rgb <0.35, 0.3, 0.25> } }
#macro Ball(Column, Row, Finish)
  sphere { 0, 0.62 translate <1.4*Column - 2.1, 1.1 - 1.4*Row, 0.6*Row*0> pigment { rgb <0.9, 0.5, 0.25> } finish { Finish } }
#end

Ball(0, 0, finish { emission 0.5 })
Ball(1, 0, finish { emission rgb <0.1, 0.5, 0.9> diffuse 0.3 })
Ball(2, 0, finish { emission 1.5 ambient 0 diffuse 0 })
Ball(3, 0, finish { emission 0.2 reflection 0.3 })
