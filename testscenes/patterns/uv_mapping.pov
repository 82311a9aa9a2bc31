// Textures in the coordinates of surfaces: of pigments, normals and textures, and of whole objects.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -12> look_at <0, 0.3, 0> angle 44 }
light_source { <-5, 9, -10> rgb 1 }
light_source { <8, 6, -9> rgb 0.5 }

#declare Tiles = pigment { uv_mapping brick rgb <1, 0.8, 0.6> rgb <0.6, 0.1, 0.1> brick_size <0.2, 0.12, 1> mortar 0.02 }
#declare Stripes = pigment { checker rgb <0.1, 0.2, 0.8> rgb <1, 0.9, 0.3> scale <1 / 16, 1 / 12, 1> }

plane { y, -1 pigment { uv_mapping gradient x color_map { [0 rgb 0.9] [1 rgb <0.4, 0.6, 0.5>] } scale 2 } }

// Spheres: as they are, turned, and pressed flat.
sphere { <-4, 1.9, 0>, 1 pigment { Tiles } }
sphere { 0, 1 pigment { Tiles } rotate <30, 40, 50> translate <-1.7, 1.9, 0> }
sphere { <0, 0.2, 0>, 1 pigment { Tiles } rotate 30 * y scale <1.1, 0.7, 0.9> rotate <0, 10, 20> translate <0.7, 1.9, 0> }
// The whole object goes by its own coordinates; its texture does not move with it.
sphere { 0, 1 uv_mapping pigment { Stripes } rotate <-20, 70, 10> translate <3.1, 1.9, 0> }

// Boxes are unfolded.
box { -0.8, 0.8 uv_mapping texture { pigment { Stripes } finish { specular 0.4 } } rotate <20, 40, 0> translate <-4, 0, 0> }
box { <-0.8, -0.5, -0.8>, <0.8, 1, 0.5> pigment { uv_mapping gradient <1, 1, 0> color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } } translate <-1.6, -0.2, 0> }
torus { 0.8, 0.35 uv_mapping pigment { Stripes } normal { bumps 0.4 scale 0.03 } rotate -50 * x translate <0.9, 0, 0> }
torus { 0.8, 0.35 pigment { rgb 0.8 } normal { uv_mapping brick 0.6 brick_size <0.1, 0.2, 1> mortar 0.02 } rotate -60 * x translate <3.2, 0, 0> }
// What has no such coordinates goes by x and y.
cylinder { <4.3, -0.9, -2>, <4.3, 0.8, -2>, 0.5 pigment { uv_mapping checker rgb 0.2 rgb 1 scale 0.3 } }
disc { <-5, -0.4, -2>, <0.3, 0.2, -1>, 0.8, 0.2 uv_mapping texture { uv_mapping pigment { checker rgb 0.2 rgb <1, 0.5, 0> scale 0.25 } } }
// Members have it from what they are in.
union {
  sphere { <0, 0, 0>, 0.5 }
  sphere { <1, 0, 0>, 0.5 pigment { checker rgb 0.1 rgb 0.9 scale 0.2 } }
  box { <1.7, -0.4, -0.4>, <2.4, 0.4, 0.4> }
  uv_mapping
  pigment { Stripes }
  rotate 15 * y
  translate <-2.4, -0.5, -3>
}
// Light is filtered as they show.
sphere { 0, 0.5 pigment { uv_mapping checker rgbf <1, 0.3, 0.3, 0.9> rgb 0.7 scale 0.1 } translate <2, 0.2, -3.4> }
