// Groups whose lights shine on their own members only; some members get the lights of the scene too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-4, 6, -5>, rgb <0.5, 0.4, 0.4> }
light_group {
  light_source { <3, 4, -4>, rgb <0.3, 0.9, 0.4> }
  sphere { <-2.6, 0.8, -1.5>, 0.8 pigment { rgb 0.9 } finish { phong 0.6 } }
  union { box { -0.4, 0.4 } sphere { 0.5*y, 0.3 } pigment { rgb <0.9, 0.8, 0.6> } translate <-1, 0.4, -3> }
}
light_group {
  light_source { <4, 3, -6>, rgb <0.4, 0.4, 1> spotlight point_at <2, 0.5, -2> radius 10 falloff 20
    looks_like { sphere { 0, 0.2 pigment { rgb 0.7 } } } }
  sphere { <2.4, 0.6, -2>, 0.6 pigment { rgb 0.9 } }
  cylinder { <1.2, 0, -3>, <1.2, 0.9, -3>, 0.3 pigment { rgbt <1, 1, 1, 0.4> } }
  global_lights on
}

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
