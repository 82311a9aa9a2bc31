// A cone that fades, is moved with its axis, and is turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { 0, rgb 1.5 spotlight radius 15 falloff 30 point_at y fade_distance 4 fade_power 1.5 rotate <160, 0, 20> translate <-2, 5, -1> }
light_source { <0, 0, 0>, rgb 1 spotlight point_at z tightness 2 scale <1, 1, 3> rotate 40*x translate <1, 6, -5> }
light_source { <6, 5, -9>, rgb 0.15 }

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
