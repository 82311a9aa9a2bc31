// Patterns that are scaled, turned, moved and sheared, in any order, in the pigment and in the texture around it.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Stripes = pigment { gradient x color_map { [0 rgb <0.9, 0.9, 0.8>] [0.5 rgb <0.2, 0.4, 0.7>] [0.5 rgb <0.8, 0.3, 0.2>] [1 rgb 0.1] } }
sphere { <-1.6, 0.2, 0>, 0.7 pigment { Stripes scale 0.4 rotate 30*z } }
sphere { <0, 0.2, 0>, 0.7 texture { pigment { Stripes rotate 60*y scale <0.3, 1, 0.2> } rotate 20*x translate 0.13*x } }
sphere { <1.6, 0.2, 0>, 0.7 pigment { Stripes matrix <0.3, 0.2, 0, 0, 0.4, 0, 0.1, 0, 0.3, 0.05, 0, 0> } }
box { <-0.6, -0.9, -1.8>, <0.8, -0.5, -1.2> pigment { checker rgb 0.9, rgb <0.3, 0.6, 0.3> translate 0.5 scale 0.2 rotate 45 } }
