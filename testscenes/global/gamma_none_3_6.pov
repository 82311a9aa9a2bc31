// Version 3.6 without assumed_gamma: no gamma at all.

#version 3.6;
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
background { rgb <0.3, 0.45, 0.7> }
sphere { <-1.2, 0, 0>, 0.9 pigment { rgb <0.9, 0.5, 0.2> } finish { phong 0.5 } }
box { <0.5, -1, -0.5>, <1.7, 0.4, 0.5> pigment { rgb 0.5 } }
