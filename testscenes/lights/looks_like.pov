// Lights that look like something: a ball, a union that is moved after it was made, glass around the light, and a light in a union.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-2, 3, -2>, rgb 0.7 looks_like { sphere { 0, 0.3 pigment { rgb <1, 1, 0.6> } finish { emission 0.8 } } } }
#declare Lamp = light_source { 0, rgb <0.4, 0.5, 0.6>
  looks_like { union { sphere { 0, 0.25 } cone { <0, 0.2, 0>, 0.2, <0, 0.9, 0>, 0.02 } pigment { rgb <0.5, 0.7, 1> } finish { emission 0.5 phong 0.6 } } } }
light_source { Lamp translate <1.5, 2.5, -2> }
object { Lamp rotate 60*z scale 1.5 translate <0, 2.2, 1> }
union {
  light_source { <3, 1, -3>, rgb 0.3 looks_like { box { -0.3, 0.3 rotate 30*y pigment { rgbt <1, 0.6, 0.4, 0.6> } } } }
  sphere { <3, 0.2, -3>, 0.2 }
  pigment { rgb <0.4, 0.8, 0.5> }
  translate -0.4*y
}

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
