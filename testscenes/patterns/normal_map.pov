// Maps and lists of normals, and their average.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { rgb 0.6 } normal { checker normal { bumps 0.6 scale 0.1 } normal { dents 0 } } }
sphere { <-1.4, 0, 0>, 0.9 pigment { rgb <0.8, 0.3, 0.2> } normal { gradient y normal_map { [0.3 bumps 0.8 scale 0.1][0.7 wrinkles 0.6 scale 0.2] } } finish { phong 0.5 } }
sphere { <0.4, 0, 0.4>, 0.8 pigment { rgb <0.2, 0.5, 0.8> } normal { average normal_map { [1 bumps 0.8 scale 0.1][2 gradient x 0.7 scale 0.2] } scale <1, 2, 1> } finish { specular 0.5 } }
box { <1.3, -1, -0.6>, <2.2, 0.6, 0.6> pigment { rgb 0.7 } normal { brick normal { bumps 1 scale 0.02 } normal { granite 0.2 } scale 0.08 } }
