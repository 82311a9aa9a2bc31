// Groups in groups, a group without lights, lights in a union in a group, and a group that is declared and moved.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-4, 6, -5>, rgb <0.5, 0.4, 0.4> }
light_group {
  light_source { <4, 5, -4>, rgb <0.2, 0.7, 0.3> }
  light_group {
    light_source { <-4, 3, -6>, rgb <0.7, 0.2, 0.2> }
    sphere { <-2.6, 0.8, -1.5>, 0.8 pigment { rgb 0.9 } }
    global_lights on
  }
  light_group { sphere { <-1, 0.4, -3>, 0.4 pigment { rgb 0.9 } } global_lights off }
  sphere { <0.6, 0.4, -3>, 0.4 pigment { rgb 0.9 } }
  global_lights on
}
light_group {
  union { light_source { <0, 3, -6>, rgb <0.2, 0.2, 0.5> } light_source { <1, 3, -6>, rgb <0.1, 0.1, 0.2> } }
  sphere { <1.6, 0.4, -3>, 0.4 pigment { rgb 0.9 } }
}
#declare Group = light_group { light_source { <0, 4, -3>, rgb <0.8, 0.8, 0.2> } box { -0.4, 0.4 pigment { rgb 0.9 } } }
object { Group translate <2.6, 0.4, -2> }

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
