// Surfaces without a texture show what they cut: of differences, intersections, in each other, with clear parts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> look_at <0, 0.4, 0> }
light_source { <-6, 9, -9> rgb 0.8 }
light_source { <7, 4, -5> rgb 0.4 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.5 } }
#declare Pieces = union {
  sphere { <-0.4, 0, 0>, 0.8 pigment { rgb <0.9, 0.2, 0.2> } }
  sphere { <0.4, 0, 0>, 0.8 pigment { rgb <0.2, 0.9, 0.2> } finish { phong 0.6 } }
  box { -0.5, 0.5 translate y * 0.5 pigment { rgb <0.2, 0.2, 0.9> } }
}
// a cut through a union
difference { object { Pieces } box { <-2, -2, -2>, <2, 2, 0> rotate y * 20 } cutaway_textures translate <-3, 0, 0> }
// a cut with a texture of its own beside one without
difference {
  object { Pieces }
  plane { z, 0 }
  box { <0, 0, -2>, <2, 2, 2> pigment { rgb <0.9, 0.8, 0.1> } }
  cutaway_textures
  translate <-0.5, 0, 0>
}
// an intersection of several: equal shares
intersection {
  sphere { <-0.3, 0, 0>, 0.9 pigment { rgb <0.9, 0.4, 0.1> } }
  sphere { <0.3, 0, 0>, 0.9 pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } scale 0.2 } }
  box { -0.6, 0.6 rotate <20, 30, 0> }
  cutaway_textures
  translate <1.7, 0, 0>
}
// a difference within an intersection, of which the outer is asked
intersection {
  difference {
    sphere { 0, 1 pigment { rgb <0.3, 0.7, 0.8> } }
    cylinder { <0, -2, 0>, <0, 2, 0>, 0.4 }
    cutaway_textures
  }
  plane { -z, 0.2 pigment { rgb <0.8, 0.3, 0.6> } }
  translate <3.6, 0, 0>
}
// what is cut is clear in part
difference {
  sphere { 0, 0.9 pigment { checker rgb <0.9, 0.9, 0.2>, rgbf <0.4, 0.8, 0.9, 0.8> scale 0.4 } }
  box { <-1, -1, -1>, <1, 1, 0> rotate <0, -25, 0> }
  cutaway_textures
  translate <-1.8, 1.7, 2>
}
// no part has a texture
#default { pigment { rgb <0.7, 0.5, 0.9> } }
difference { box { -0.6, 0.6 } sphere { <-0.4, 0.5, -0.5>, 0.7 } cutaway_textures rotate y * 25 translate <1.2, 1.8, 2> }
// members of a union without a texture have the usual one
difference {
  sphere { 0, 0.8 pigment { rgb <0.9, 0.5, 0.5> } }
  union { box { <0, -1, -1>, <1, 1, 1> } sphere { <-0.6, 0.2, -0.6>, 0.4 } }
  cutaway_textures
  translate <3, 2, 2>
}
