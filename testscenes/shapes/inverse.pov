// inverse turns inside and outside: a box as the cutter of an intersection, a cone, and a whole union turned.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

intersection {
  sphere { 0, 1 }
  box { <-0.4, -2, -2>, <0.4, 2, 2> inverse }
  pigment { rgb <0.9, 0.4, 0.2> }
  translate <-1.2, 0, 0>
}
intersection {
  box { -0.8, 0.8 }
  union { sphere { -0.5*x, 0.6 } sphere { <0.5, 0.4, -0.5>, 0.6 } inverse }
  cone { -y, 1, y, 0.2 inverse }
  pigment { rgb <0.3, 0.7, 0.9> }
  rotate 25*y
  translate <1.2, 0, 0>
}
