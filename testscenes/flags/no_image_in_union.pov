// A member of a union that is not split is hidden from what has come through glass, not from the camera itself.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.2, 1.5, -4> look_at 0 }
light_source { <4, 6, -5> rgb 0.9 }
plane { y, -1 pigment { checker rgb 0.7, rgb 0.3 } finish { reflection 0.3 } }
union {
  sphere { <-0.5, 0, 0>, 0.8 pigment { rgb <1, 0.3, 0.2> } no_image }
  sphere { <0.5, 0, 0>, 0.8 pigment { rgbt <0.2, 0.5, 1, 0.4> } }
  split_union off
}
