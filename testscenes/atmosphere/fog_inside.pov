// The camera in a body that is not hollow: no fog until the ray has left it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at <0, 1, 0> angle 80 }
light_source { <20, 30, -20> rgb 1 shadowless }
background { rgb <0.2, 0.4, 0.9> }
fog { distance 6 rgb <0.9, 0.6, 0.5> }
box { <-8, -0.5, -6>, <0.5, 4, -2> pigment { rgbf <0.9, 1, 0.9, 0.8> } }
box { <0.6, 0, 0>, <4, 3, 2> pigment { rgbf <0.9, 1, 0.9, 0.8> } hollow }
sphere { <-2, 1, -3>, 0.5 pigment { rgb x } }
sphere { <2, 1, 1>, 0.5 pigment { rgb x } }
plane { y, 0 pigment { checker rgb 0.3 rgb 0.6 } finish { reflection 0.2 } }
