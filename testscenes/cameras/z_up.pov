// A world whose z axis points up: sky z, and what is then right.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }

camera { location <0, -8, 2.4> sky z up z right x*4/3 look_at <0, 0, 0.3> }
plane { z, -1 pigment { checker rgb 0.8, rgb 0.3 } }
light_source { <-4, -5, 6>, rgb 1 }
cone { <0, 0, -1>, 1, <0, 0, 1.3>, 0.2 pigment { rgb <0.9, 0.3, 0.2> } }
box { <1.5, -0.5, -1>, <2.5, 0.5, 1> pigment { rgb <0.3, 0.7, 0.9> } }
