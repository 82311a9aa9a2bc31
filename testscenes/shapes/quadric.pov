// Surfaces of the second degree: an ellipsoid, a cylinder, a cone, paraboloids and hyperboloids, whole, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.5, -11> look_at <0, 0.2, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

quadric { <1, 2, 1.5>, <0, 0, 0>, <0.3, 0, -0.2>, -0.8 pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } translate <-3.8, 0, 0> }
quadric { <1, 1, 1>, <0.8, -0.5, 0.3>, 0, -0.5 pigment { rgb <0.4, 0.7, 0.9> } rotate <20, 30, 40> scale <1, 1.3, 0.8> translate <-1.6, 0.1, 0> }
intersection {
  quadric { <1, 0, 1>, 0, 0, -0.3 rotate 25 * z }
  box { -1, 1 }
  pigment { rgb <0.8, 0.3, 0.3> }
  translate <0.5, 0, 0.4>
}
// Both sheets of a cone, and one of a hyperboloid.
quadric { <1, -1, 1>, 0, 0, 0 clipped_by { box { -1, 1 } } pigment { rgb <0.3, 0.7, 0.3> } interior_texture { pigment { rgb <0.9, 0.4, 0.8> } } translate <2.7, 0, 0.4> }
quadric { <1, -1, 1>, 0, 0, -0.2 bounded_by { box { -1, 1 } } clipped_by { bounded_by } pigment { rgb <0.6, 0.5, 0.9> } scale 0.7 rotate <30, 0, 20> translate <-3.2, -0.3, -2.8> }
quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 clipped_by { plane { y, 1 } } pigment { rgb <0.9, 0.6, 0.3> } rotate 20 * x translate <-1, -0.7, -2.6> }
difference {
  box { <-0.9, -0.8, -0.9>, <0.9, 0.5, 0.9> }
  quadric { <1, 0, -1>, 0, <0, -1, 0>, 0 }
  pigment { rgb <0.5, 0.8, 0.8> }
  rotate -30 * y
  translate <1.3, -0.3, -2.8>
}
difference {
  sphere { 0, 0.8 }
  quadric { <1, 1, 0>, 0, 0, -0.15 inverse }
  pigment { rgb <0.8, 0.8, 0.4> }
  rotate <0, 40, 0>
  translate <3.4, -0.5, -2.8>
}
