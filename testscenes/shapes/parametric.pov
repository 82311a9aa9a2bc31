// Containers of both kinds, coordinates worked out before, the surface's own coordinates, and what is cut.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4.5, -11> look_at <0, 0.1, 0> angle 75 }
light_source { <-5, 9, -8> rgb 0.9 shadowless }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }
#declare Checks = pigment { checker rgb <0.2, 0.3, 0.7> rgb <1, 0.9, 0.6> scale <0.5, 0.5, 1> }
#declare Wave = function (a, b) { 0.3 * sin(3 * a) * cos(2 * b) }

parametric {
  function { sin(u) * cos(v) }, function { sin(u) * sin(v) }, function { cos(u) }
  <0, 0>, <pi, 2*pi>
  contained_by { sphere { 0, 1.1 } }
  max_gradient 1.1 accuracy 0.03 precompute 10 x, y, z
  pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 }
  translate <-3.2, 0, 0.5>
}
parametric {
  function { u }, function { Wave(u, v) } function { v }
  <-1, -1>, <1, 1>
  contained_by { box { <-1.05, -0.6, -1.05>, <1.05, 0.6, 1.05> } }
  max_gradient 1.2 accuracy 0.03
  pigment { rgb <0.4, 0.7, 0.9> }
  rotate <-30, 20, 0>
  translate <-0.4, 0, 0.6>
}
parametric {
  function { (0.7 + 0.25 * cos(v)) * cos(u) }, function { 0.25 * sin(v) }, function { (0.7 + 0.25 * cos(v)) * sin(u) }
  <0, 0>, <2*pi, 2*pi>
  contained_by { box { <-1, -0.3, -1>, <1, 0.3, 1> } }
  max_gradient 1 accuracy 0.03 precompute 12 x, z
  uv_mapping pigment { Checks }
  scale <1.1, 1.4, 1.1> rotate -40 * x
  translate <2.6, 0, 0.5>
}
parametric {
  function { 0.6 * u * cos(v) }, function { 0.4 * u - 0.3 }, function { 0.6 * u * sin(v) }
  <0.2, 0>, <1.4, 5>
  contained_by { sphere { 0, 1.2 } }
  max_gradient 1 accuracy 0.03
  pigment { rgb <0.9, 0.4, 0.3> }
  interior_texture { pigment { uv_mapping Checks } }
  clipped_by { plane { x, 0.5 } }
  translate <-1.6, -0.3, -2.7>
}
intersection {
  box { -0.7, 0.7 }
  parametric { function { u } function { 0.2 * sin(6 * u) + 0.3 * v } function { v } <-1, -1>, <1, 1> max_gradient 1.2 accuracy 0.03 }
  pigment { rgb <0.6, 0.5, 0.9> }
  rotate -30 * y translate <1.4, -0.4, -2.7>
}
