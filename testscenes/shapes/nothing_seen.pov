// Triangles without an end and landscapes of one row or column: nothing is seen of them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.2, 1.5, -4> look_at 0 }
light_source { <4, 6, -5> rgb 0.9 }
plane { y, -1 pigment { checker rgb 0.7, rgb 0.3 } }
#declare Endless = 1e200*1e200;
#declare Undefined = Endless - Endless;
#default { pigment { rgb <1, 0.5, 0.2> } }
mesh {
  triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> }
  triangle { <-1, 1, 0>, <Endless, 1, 0>, <0, 1.5, 0> }
  triangle { <-1, 1, 0>, <1, 1, 0>, <Undefined, 1.5, 0> }
}
mesh2 {
  vertex_vectors { 5, <-2, -1, 1>, <-1, -1, 1>, <-1.5, 1, 1>, <Endless, 1, 0>, <0, -Endless, 0> }
  face_indices { 3, <0, 1, 2>, <0, 1, 3>, <2, 1, 4> }
}
height_field { function 1, 1 { 0.5 } scale 2 translate <-1, 0, -1> }
height_field { function 2, 1 { x } scale 2 translate <-1, 0.5, -1> }
height_field { function 1, 2 { y } scale 2 translate <-1, 0.7, -1> }
sphere { <1.5, 0, 0>, 0.5 }
