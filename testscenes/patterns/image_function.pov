// Pictures that are painted by functions.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }

box { <-2.9, 0.1, 0>, <-0.1, 2, 0.1> pigment { image_map { function 30, 20 { x*y } } scale 1.9 } }
box { <0.1, 0.1, 0>, <2.9, 2, 0.1> pigment { image_map { function 40, 40 { pigment { bozo color_map { [0 rgb <1, 0.2, 0.1>] [0.5 rgbt <0.1, 0.8, 0.3, 0.5>] [1 rgb 1] } scale 0.2 } } interpolate 2 } scale 1.9 } }
box { <-2.9, -2, 0>, <-0.1, -0.1, 0.1> pigment { rgb 0.8 } normal { bump_map { function 50, 50 { sin(20*x)*sin(30*y)/2 + 0.5 } bump_size 3 } scale 1.9 } }
sphere { <1.5, -1, 0>, 0.9 pigment { image_pattern { function 16, 16 { abs(sin(x*4 + y*2)) } map_type 1 } color_map { [0 rgb x] [1 rgb y] } } }
plane { z, 2 pigment { checker rgb 0.2 rgb 0.5 scale 0.3 } }
