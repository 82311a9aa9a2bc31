// Lights without shadow and highlights, of each kind that can be.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-4, 5, -4>, rgb 0.5 shadowless }
light_source { <4, 5, -4>, rgb <0.3, 0.2, 0.2> shadowless parallel point_at 0 }
light_source { <4, 4, -6>, rgb 0.4 area_light 3*x, 3*y, 3, 3 shadowless }
light_source { <-2, 4, -6>, rgb 0.4 area_light 3*x, 3*y, 3, 3 area_illumination shadowless }

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
