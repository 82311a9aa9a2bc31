// Lengths change with the camera, the focal distance does not.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
light_source { <-4, 6, -5>, rgb 1 }
camera { location <0, 0.5, -3> look_at <0, 0.3, 0> right x*4/3 aperture 0.4 blur_samples 7 focal_point <0, 0, 0> scale 2 rotate 10*y }
plane { y, -1.5 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
sphere { <0, 0.2, 3>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
box { <2.5, -1.5, -0.5>, <3.5, 1.5, 0.5> pigment { rgb <0.3, 0.7, 0.9> } }
cone { <-3, -1.5, 0>, 0.8, <-3, 1.2, 0>, 0 pigment { rgb <0.6, 0.9, 0.3> } }
sphere { <0, 0, -3>, 0.9 pigment { rgb <0.9, 0.8, 0.3> } }
sphere { <0.5, 3, 0.3>, 0.6 pigment { rgb <0.8, 0.3, 0.8> } }
cylinder { <1.5, -1.5, 2>, <1.5, 2, 2.4>, 0.3 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.6 } }
