// interior_texture: another texture inside than outside, on open shapes and on a shape that is cut.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { 0, 0.8 clipped_by { plane { z, 0 rotate -30*y } } texture { pigment { rgb <0.9, 0.3, 0.2> } } interior_texture { pigment { checker rgb 1, rgb <0.2, 0.4, 0.9> scale 0.2 } } rotate 150*y translate -1.4*x }
cylinder { -0.8*y, 0.4*y, 0.6 open texture { pigment { rgb <0.3, 0.7, 0.3> } } interior_texture { pigment { rgb <0.9, 0.8, 0.2> } finish { ambient 0.5 } } translate 0.2*x }
disc { <1.6, 0.2, 0>, <0.3, 0, 1>, 0.7 texture { pigment { rgb <0.9, 0.2, 0.9> } } interior_texture { pigment { gradient y scale 0.3 } } }
