// srgb, srgbf, srgbt colours are turned to linear light.

#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
background { srgb <0.3, 0.45, 0.7> }
sphere { <-1.6, 0, 0>, 0.7 pigment { srgb <0.9, 0.5, 0.2> } }
sphere { <0, 0, 0>, 0.7 pigment { color srgbt <0.2, 0.5, 0.9, 0.5> } }
sphere { <1.6, 0, 0>, 0.7 pigment { srgbf <0.2, 0.9, 0.5, 0.5> } }
box { <-0.5, -1, -1.6>, <0.5, -0.7, -1.2> pigment { gradient x color_map { [0 srgb 0] [1 srgb <1, 0.6, 0.1>] } } }
box { <-2.5, 1.3, 0>, <2.5, 1.6, 0.2> pigment { color srgbft <0.5, 0.6, 0.7, 0.1, 0.2> } finish { ambient srgb 0.5 } }
