// Twins beside an infinite plane, and few other objects: the last of them is seen.
#version 3.7; global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { location <2,3,-6> look_at 0 angle 35 right x*4/3 }
box { <-1,-1,-1>, <0,0,1> pigment { rgb x } } box { <-1,-1,-1>, <0,0,1> pigment { rgb z } }
sphere { x, 0.5 pigment { rgb x } } sphere { x, 0.5 pigment { rgb z } }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
