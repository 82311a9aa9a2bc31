// Shadows through coloured glass: filter tints the light, transmit dims it less, both, and two panes in a row.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.1, 0.15, 0.25> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

light_source { <-3, 6, -4>, rgb 1 }

box { <-2, -0.2, -0.6>, <-1, 0.8, -0.5> pigment { rgbf <1, 0.2, 0.2, 0.9> } }
box { <-0.7, -0.2, -0.6>, <0.3, 0.8, -0.5> pigment { rgbt <0.2, 1, 0.2, 0.7> } }
box { <0.6, -0.2, -0.6>, <1.6, 0.8, -0.5> pigment { rgbft <0.2, 0.4, 1, 0.5, 0.3> } }
box { <1.1, -0.6, -0.2>, <2.1, 0.4, -0.1> pigment { rgbf <1, 1, 0.1, 0.8> } }
sphere { <0, -0.6, -1.8>, 0.4 pigment { rgbf <1, 0.6, 0.1, 0.8> } }
