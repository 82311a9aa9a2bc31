// Shapes without a pigment are black; #default gives one, from there on.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { <-1.4, 0, 0>, 0.7 finish { phong 0.8 } }
#default { pigment { rgb <0.9, 0.6, 0.2> } }
sphere { <0, 0, 0>, 0.7 }
#default { texture { pigment { rgb <0.2, 0.6, 0.9> } finish { phong 0.5 ambient 0.3 } } }
sphere { <1.4, 0, 0>, 0.7 }
#default { finish { ambient 0 } }
box { <-0.5, -0.9, -1.8>, <0.5, -0.6, -1.2> }
