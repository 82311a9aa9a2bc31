// conserve_energy: what is reflected is taken from what shines through, beside the same without it.
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

sphere { <-1.2, 0.4, 0>, 1 pigment { rgbt <0.6, 0.8, 1, 0.8> } finish { diffuse 0.3 reflection { 0.6 } } interior { ior 1.2 } }
sphere { <1.2, 0.4, 0>, 1 pigment { rgbt <0.6, 0.8, 1, 0.8> } finish { diffuse 0.3 reflection { 0.6 } conserve_energy } interior { ior 1.2 } }
sphere { <0, -0.5, -1.5>, 0.5 pigment { rgbf <1, 0.9, 0.8, 0.9> } finish { reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.5 } }
