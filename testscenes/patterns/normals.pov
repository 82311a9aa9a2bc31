// Normals of every kind of pattern: with tilts of their own, and by heights; with a slope map; scaled and turned.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } normal { dents 1 scale 0.4 } }
sphere { <-1.6, 0.3, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } normal { wrinkles 0.7 scale 0.3 } finish { phong 0.6 } }
sphere { <-0.1, 0.3, 0.4>, 0.7 pigment { rgb <0.2, 0.5, 0.8> } normal { granite 0.3 scale 0.5 accuracy 0.01 } finish { specular 0.5 } }
sphere { <1.4, 0.3, 0>, 0.7 pigment { rgb 0.7 } normal { gradient y 0.6 slope_map { [0 <0, 1>][0.5 <1, 0>][0.5 <1, -1>][1 <0, -1>] } scale 0.2 rotate z*20 } }
sphere { <-0.9, -0.6, -1.2>, 0.4 pigment { rgb <0.9, 0.8, 0.3> } normal { quilted 0.8 control0 0.3 control1 0.9 scale 0.2 } }
sphere { <0.3, -0.6, -1.2>, 0.4 pigment { rgbf <0.9, 1, 0.9, 0.8> } normal { bumps 0.4 scale 0.1 } interior { ior 1.4 } finish { reflection 0.1 } }
box { <1, -1, -1.4>, <1.8, -0.4, -0.9> pigment { rgb <0.6, 0.4, 0.8> } normal { wood 0.5 turbulence 0.1 scale 0.15 } rotate y*10 }
