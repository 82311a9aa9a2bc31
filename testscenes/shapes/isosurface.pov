// Containers of both kinds, gradients that are given and found, open and closed, cut and cutting, of functions of all kinds.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -11> look_at <0, 0.1, 0.2> angle 50 }
light_source { <-6, 10, -9> rgb 0.9 }
light_source { <9, 5, -6> rgb 0.35 shadowless }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }
#declare Wood = finish { phong 0.5 }
#declare Blades = function (x, y, z, k) { sin(k * x) * cos(k * y) + sin(k * y) * cos(k * z) + sin(k * z) * cos(k * x) }
#declare Knobs = function { pattern { bumps scale 0.35 } }
#declare Marks = function { pigment { gradient y color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0.2>] [1 rgb 0] } scale 0.4 } }

isosurface { function { sqrt(x*x + y*y + z*z) - 0.9 } pigment { rgb <1, 0.8, 0.3> } finish { Wood } translate <-4.2, 0, 0.6> }
isosurface {
  function { Blades(x, y, z, 4) }
  contained_by { sphere { 0, 1 } }
  threshold 0.2 max_gradient 8 accuracy 0.002
  pigment { rgb <0.4, 0.7, 0.9> }
  translate <-2.1, 0, 0.8>
}
isosurface {
  function { sqrt(x*x + y*y + z*z) - 0.95 + 0.35 * Knobs(x, y, z) }
  contained_by { box { -1.1, 1.1 } }
  max_gradient 3
  pigment { rgb <0.8, 0.5, 0.4> }
  scale <1, 0.8, 1> rotate 30 * z translate <0.1, 0, 1>
}
// Open, with its back seen through the opening.
isosurface {
  function { x*x + z*z - 0.5 - 0.2 * sin(5 * y) }
  contained_by { box { <-1, -0.9, -1>, <1, 0.9, 1> } }
  open max_gradient 2.5
  pigment { rgb <0.5, 0.9, 0.5> }
  interior_texture { pigment { rgb <0.9, 0.3, 0.2> } }
  rotate <-40, 0, 15> translate <2.2, 0.1, 0.8>
}
// Its gradient is found on the way.
isosurface {
  function { pow(abs(x), 3) + pow(abs(y), 3) + pow(abs(z), 3) - 0.7 + 0.1 * Marks(x, y, z).gray }
  evaluate 1, 1.3, 0.98
  contained_by { sphere { 0, 1.3 } }
  pigment { rgb <0.8, 0.6, 0.9> }
  scale 0.9 rotate 35 * y translate <4.3, 0, 0.4>
}
// Several surfaces behind each other, for what is made of several shapes.
#declare Rings = isosurface {
  function { sin(12 * sqrt(x*x + z*z)) * 0.1 + y }
  contained_by { box { <-1, -0.6, -1>, <1, 0.6, 1> } }
  max_gradient 1.7 all_intersections
}
difference { object { Rings } cylinder { -y, y, 0.4 } pigment { rgb <0.9, 0.8, 0.6> } rotate 20 * x translate <-3, -0.3, -2.4> }
intersection { box { -0.8, 0.8 } object { Rings inverse } pigment { rgb <0.6, 0.8, 0.8> } rotate <25, 30, 0> translate <-0.6, -0.3, -2.6> }
merge {
  isosurface { function { abs(x) + abs(y) + abs(z) - 0.8 } max_gradient 1.8 max_trace 2 }
  sphere { 0.5, 0.5 }
  pigment { rgbt <0.5, 0.6, 1, 0.5> } finish { phong 0.8 }
  translate <1.6, -0.3, -2.8>
}
// A gradient that is too small leaves holes.
isosurface {
  function { y - 0.5 * sin(9 * x) * cos(9 * z) }
  contained_by { box { <-0.8, -0.6, -0.8>, <0.8, 0.6, 0.8> } }
  max_gradient 1.6
  clipped_by { plane { x, 0.55 } }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate -20 * y translate <3.5, -0.4, -2.4>
}
