// Facets by direction and by place.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { rgb 0.8 } normal { facets 0.3 } finish { specular 0.4 } })
Ball(1, 0, texture { pigment { rgb 0.8 } normal { facets size 0.6 } })
Ball(2, 0, texture { pigment { rgb 0.8 } normal { facets coords 1 scale 0.3 } })
Ball(3, 0, texture { pigment { rgb 0.8 } normal { facets coords 0.5 size 0.4 metric 3 scale 0.5 } })
Ball(0, 1, texture { pigment { rgb 0.8 } normal { facets size 0.4 metric 1 } })
Ball(1, 1, texture { pigment { rgb 0.3 } normal { facets 0.2 scale <1, 2, 0.5> } finish { reflection 0.6 } })
plane { z, 2 pigment { checker rgb 0.2 rgb 0.5 } }
