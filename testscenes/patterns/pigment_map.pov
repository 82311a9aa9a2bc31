// A map of pigments instead of colours, and checkers of pigments in one another.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Dots = pigment { checker rgb <0.9, 0.8, 0.2>, rgb <0.7, 0.1, 0.1> scale 0.1 }
sphere { <-1.4, 0, 0>, 0.9 pigment { gradient y pigment_map { [0 Dots] [0.5 rgb <0.2, 0.5, 0.9>] [1 gradient x scale 0.2] } scale 1.1 } }
box { <0.4, -0.9, -0.6>, <1.8, 0.7, 0.6> rotate 20*y pigment { checker pigment { Dots }, pigment { gradient z color_map { [0 rgb 0] [1 rgb <0.4, 0.9, 0.6>] } scale 0.3 } scale 0.45 } }
