// Transparent shapes: a merge has no surfaces inside, the union beside it shows them.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Glass = texture { pigment { rgbt <0.6, 0.9, 0.8, 0.7> } finish { phong 0.5 } }
merge {
  sphere { -0.35*x, 0.7 } sphere { 0.35*x, 0.7 } cylinder { -0.9*y, y, 0.3 }
  texture { Glass }
  translate <-1.2, 0, 0>
}
union {
  sphere { -0.35*x, 0.7 } sphere { 0.35*x, 0.7 } cylinder { -0.9*y, y, 0.3 }
  texture { Glass }
  translate <1.2, 0, 0>
}
