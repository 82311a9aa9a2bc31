// Radius above falloff, equal ones, a cone of more than a half space, and no cone at all.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-4, 5, -4>, rgb 0.9 spotlight radius 25 falloff 15 point_at <-1, 0, 0> }
light_source { <4, 5, -5>, rgb <0.7, 0.8, 0.9> spotlight radius 12 falloff 12 point_at <1, 0.5, 0> }
light_source { <0, 6, 4>, rgb 0.3 spotlight radius 80 falloff 120 tightness 0 point_at <0, 6, -2> }
light_source { <0, 6, -4>, rgb 0.4 spotlight radius 95 falloff 100 tightness 3 point_at <0, 0, 1> }
light_source { <6, 5, -9>, rgb 0.15 }

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
