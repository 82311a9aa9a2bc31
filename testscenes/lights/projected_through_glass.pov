// Only what stands between the window and what is lit casts shadow; an area light and a parallel one come through, too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-3, 6, -4>, rgb 0.6 area_light 1*x, 1*z, 3, 3 projected_through { disc { <-1.5, 3, -1.5>, y, 1.2 } } }
light_source { <3, 6, -4>, rgb <0.4, 0.5, 0.8> parallel point_at <1, 0, 0> projected_through { box { <0, 3, -2>, <2.5, 3.1, 0> } } }
sphere { <-2.2, 4.6, -2.7>, 0.4 pigment { rgb 0.8 } }
sphere { <-1.5, 2.2, -1.5>, 0.6 pigment { rgbf <0.9, 0.5, 0.4, 0.8> } }
light_source { <-6, 6, -9>, rgb 0.2 }

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
