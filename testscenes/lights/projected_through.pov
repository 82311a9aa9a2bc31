// Windows: one that is nearer than the light, one beyond it, one that is missed in part, one without shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-3, 5, -4>, rgb 0.8 projected_through { box { <-2.6, 3, -3>, <-1.4, 3.1, -1.5> } } }
light_source { <3, 5, -4>, rgb <0.3, 0.5, 0.8> projected_through { difference { sphere { <2, 3, -2>, 1 } plane { -y, -3 } } } }
light_source { <0, 3, -6>, rgb <0.6, 0.3, 0.2> shadowless projected_through { torus { 0.6, 0.15 rotate 90*x translate <0, 2, -3> } } }
light_source { <0, 1, -8>, rgb <0.9, 0.2, 0.2> projected_through { sphere { <0, 1, -20>, 2 } } }
light_source { <-6, 6, -9>, rgb 0.2 }

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
