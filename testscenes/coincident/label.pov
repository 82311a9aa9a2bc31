// A disc and a triangle that lie on faces of a box: seen is what the ray enters first, whose box is thicker.
#version 3.7; global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { location <2,3,-6> look_at 0 angle 35 right x*4/3 }
plane { y, -3 pigment { rgb y } } sphere { <2,0,0>, 0.3 } sphere { <-2,0,0>, 0.3 } sphere { <2,1,0>, 0.3 } sphere { <-2,1,0>, 0.3 }
box { -1, 1 pigment { rgb z } }
disc { <0,0,-1>, z, 0.5 pigment { rgb x } }
triangle { <-1,1,-1>, <1,1,-1>, <0,1,1> pigment { rgb x+z } }
