// Triangles as indices into lists: textures, texture coordinates, normals, with indices of their own and without.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1 pigment { checker rgb 0.8 rgb 0.6 } }

#declare Checks = pigment { checker rgb <0.2, 0.3, 0.7> rgb <1, 0.9, 0.6> scale 0.125 }
#declare N = 12;

// A wavy sheet over the unit square, given by its points.
#macro Height(U, V) 0.18 * sin(U * 9) * cos(V * 7) #end
#macro Points()
  vertex_vectors { (N + 1) * (N + 1),
    #for (J, 0, N) #for (I, 0, N) <I / N, Height(I / N, J / N), J / N>, #end #end }
#end
#macro Normals()
  normal_vectors { (N + 1) * (N + 1),
    #for (J, 0, N) #for (I, 0, N)
      #local U = I / N; #local V = J / N;
      <-1.62 * cos(U * 9) * cos(V * 7), 1, 1.26 * sin(U * 9) * sin(V * 7)>,
    #end #end }
#end
#macro Coordinates()
  uv_vectors { (N + 1) * (N + 1), #for (J, 0, N) #for (I, 0, N) <I / N, J / N>, #end #end }
#end
#macro Faces(Suffix)
  #for (J, 0, N - 1) #for (I, 0, N - 1)
    #local A = J * (N + 1) + I;
    <A, A + 1, A + N + 2> #if (Suffix) , mod(I + J, 3) #end ,
    <A, A + N + 2, A + N + 1> #if (Suffix) , mod(I, 3), mod(J, 3), 1 #end ,
  #end #end
#end

mesh2 { Points() face_indices { 2 * N * N, Faces(false) } pigment { rgb <0.8, 0.4, 0.2> } scale 2.6 rotate -25 * x translate <-4, -0.6, 0> }
mesh2 { Points() Normals() face_indices { 2 * N * N, Faces(false) } pigment { rgb <0.4, 0.7, 0.3> } finish { phong 0.7 } scale 2.6 rotate -25 * x translate <-1.2, -0.6, 0> }
mesh2 { Points() Normals() Coordinates() face_indices { 2 * N * N, Faces(false) } uv_mapping pigment { Checks } scale 2.6 rotate -25 * x translate <1.6, -0.6, 0> }
mesh2 {
  Points()
  texture_list { 3,
    texture { pigment { rgb <0.9, 0.2, 0.1> } finish { specular 0.4 } },
    texture { pigment { gradient x color_map { [0 rgb 1] [1 rgb <0.1, 0.2, 0.7>] } scale 0.2 } },
    texture { pigment { rgbf <0.6, 1, 0.6, 0.7> } } }
  face_indices { 2 * N * N, Faces(true) }
  scale 1.8 rotate <-50, 20, 0> translate <-2.6, -0.6, -2.6>
}
// Indices of coordinates and of normals.
mesh2 {
  vertex_vectors { 5, <0, 1.2, 0>, <-1, 0, -1>, <1, 0, -1>, <1, 0, 1>, <-1, 0, 1> }
  normal_vectors { 3, <0, 1, 0>, <0, 0.5, -1>, <1, 0.5, 0> }
  uv_vectors { 3, <0, 0>, <1, 0>, <0.5, 1> }
  face_indices { 6, <0, 1, 2>, <0, 2, 3>, <0, 3, 4>, <0, 4, 1>, <1, 3, 2>, <1, 4, 3> }
  uv_indices { 6, <2, 0, 1>, <2, 0, 1>, <2, 0, 1>, <2, 0, 1>, <0, 1, 2>, <0, 1, 2> }
  normal_indices { 2, <0, 1, 1>, <0, 2, 2> }
  inside_vector <0.1, 1, 0.1>
  pigment { uv_mapping brick rgb 1 rgb <0.7, 0.2, 0.1> brick_size <0.3, 0.15, 1> mortar 0.02 }
  rotate -30 * y
  translate <1, -0.98, -2.4>
}
