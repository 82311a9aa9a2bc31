// bounded_by: POV-Ray removes the bounds of shapes and unions that have their own (so that one too small does not cut
// them), keeps those of a difference or intersection (where it does), and moves them with the shape.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

union {
  sphere { -0.5*x, 0.5 } sphere { 0.5*x, 0.5 }
  bounded_by { box { <-1.1, -0.6, -0.6>, <1.1, 0.6, 0.6> } }
  pigment { rgb <0.9, 0.4, 0.2> }
  rotate 30*z
  translate <-1.5, 0.6, 0>
}
sphere {
  0, 0.7
  bounded_by { box { <-0.9, -0.9, -1>, <0.5, 0.4, 1> } }
  pigment { rgb <0.3, 0.7, 0.9> }
  translate <1.4, 0.2, 0>
}
difference {
  box { -0.5, 0.5 }
  sphere { -0.5*z, 0.4 }
  bounded_by { sphere { 0, 0.9 } }
  pigment { rgb <0.6, 0.9, 0.3> }
  rotate 20*y
  translate <0.6, -0.5, -1>
}
intersection {
  box { -0.5, 0.5 }
  plane { x, 0.4 }
  bounded_by { sphere { 0, 0.55 } }
  pigment { rgb <0.9, 0.8, 0.3> }
  rotate 40*y
  translate <-0.9, -0.5, -1>
}
