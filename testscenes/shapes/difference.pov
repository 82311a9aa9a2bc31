// Differences: the cut shows the texture of what cuts, or of the whole when that has none; several cuts, planes as cutters.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

difference {
  box { <-0.8, -1, -0.8>, <0.8, 0.6, 0.8> pigment { rgb <0.9, 0.6, 0.3> } }
  sphere { <0, 0.6, -0.6>, 0.6 pigment { rgb <0.3, 0.5, 0.9> } finish { phong 0.7 } }
  cylinder { <-2, -0.4, 0>, <2, -0.4, 0>, 0.25 pigment { rgb <0.8, 0.2, 0.2> } }
  rotate 30*y
  translate -1.1*x
}
difference {
  sphere { 0, 1 }
  sphere { 0, 0.8 }
  plane { z, 0 rotate 25*x }
  plane { -x, -0.5 }
  pigment { rgb <0.4, 0.8, 0.5> }
  translate <1.2, 0, 0.4>
}
difference {
  cylinder { -0.2*z, 0.2*z, 0.5 }
  union { box { <-0.1, -1, -1>, <0.1, 1, 1> } box { <-1, -0.1, -1>, <1, 0.1, 1> rotate 20*z } }
  pigment { rgb <0.8, 0.8, 0.2> }
  translate <0.3, -0.5, -1.8>
}
