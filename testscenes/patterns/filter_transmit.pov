// filter and transmit: what is behind shows, tinted or not; as words of the pigment after its colours too.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

box { <-2, -0.9, -1>, <-0.8, 1, -0.9> pigment { rgbf <0.9, 0.3, 0.2, 0.8> } }
box { <-0.6, -0.9, -1>, <0.6, 1, -0.9> pigment { rgbt <0.9, 0.3, 0.2, 0.8> } }
box { <0.8, -0.9, -1>, <2, 1, -0.9> pigment { rgbft <0.9, 0.3, 0.2, 0.4, 0.4> } }
sphere { <0, 0.4, 1>, 0.6 pigment { rgb <0.2, 0.5, 0.9> } }
sphere { <-1.6, 0.9, 1>, 0.5 pigment { rgb <0.2, 0.9, 0.5> } }
