// Surfaces of the third degree.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -7> look_at <0, 0.2, 0> angle 40 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

// x^3 + y^3 + z^3 + 1 - (x + y + z + 1)^3 / 4, of Cayley, without its far ends
cubic {
  <0.75, -0.75, -0.75, -0.75, -0.75, -1.5, -1.5, -0.75, -1.5, -0.75, 0.75, -0.75, -0.75, -0.75, -1.5, -0.75, 0.75, -0.75, -0.75, 0.75>
  clipped_by { sphere { 0, 1.3 } }
  pigment { rgb <0.4, 0.7, 0.9> } finish { phong 0.5 }
  interior_texture { pigment { rgb <0.9, 0.5, 0.3> } }
  rotate <0, 30, 0>
  translate <-1.4, 0.2, 0>
}
intersection {
  cubic { <1, 0, 0, 0, 0, 0, 0, -3, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0> sturm }
  box { -1, 1 }
  pigment { rgb <1, 0.8, 0.3> }
  rotate -20 * y
  translate <1.4, -0.1, 0>
}
