// Before version 3.7 all that nothing stands before shows through, and the sky is seen in mirrors.
#version 3.5;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.4, 0.6> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.3, 0.5, 0.9>] [0.5 rgbt <1, 1, 1, 1>] } } }
camera { location <0, 1, -6> look_at 0 }
light_source { <5, 5, -9> rgb 1 }
sphere { <-1.5, 0, 0>, 1 pigment { rgbf <0.9, 0.5, 0.3, 0.6> } finish { phong 0.9 } }
sphere { <1.5, 0, 0>, 1 pigment { rgb <0.2, 0.5, 0.3> } finish { reflection 0.6 } }
