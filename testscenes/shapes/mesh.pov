// Triangles one by one: flat and smooth, with textures of their own and of their corners, solid and not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 48 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1 pigment { checker rgb 0.8 rgb 0.6 } }

#declare Red = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.6 } }
#declare Dots = texture { pigment { spotted color_map { [0.4 rgb 1] [0.4 rgb <0.1, 0.3, 0.8>] } scale 0.2 } }
#declare Glass = texture { pigment { rgbf <0.6, 1, 0.6, 0.8> } }

// The corners of an octahedron, so that a round one can be made of it.
#macro Side(A, B, C)
  triangle { A, B, C }
#end
#macro RoundSide(A, B, C, N)
  #if (N = 0)
    smooth_triangle { A, A, B, B, C, C }
  #else
    #local AB = vnormalize(A + B);
    #local BC = vnormalize(B + C);
    #local CA = vnormalize(C + A);
    RoundSide(A, AB, CA, N - 1) RoundSide(B, BC, AB, N - 1) RoundSide(C, CA, BC, N - 1) RoundSide(AB, BC, CA, N - 1)
  #end
#end
#macro Octahedron(Round)
  #for (I, 0, 7)
    #local X = x * (mod(I, 2) * 2 - 1);
    #local Y = y * (mod(int(I / 2), 2) * 2 - 1);
    #local Z = z * (int(I / 4) * 2 - 1);
    #if (Round) RoundSide(X, Y, Z, 2) #else Side(X, Y, Z) #end
  #end
#end

#declare Ball = mesh { Octahedron(true) inside_vector <0.1, 1, 0.2> }
object { Ball pigment { rgb <1, 0.8, 0.3> } finish { specular 0.5 } translate <-3.2, 0.2, 0> }
object { Ball texture { Red } scale <0.6, 1.2, 0.8> rotate <10, 20, 40> translate <-1.2, 0.4, 0.4> }
// Solid ones can be cut, and cut others.
difference {
  object { Ball }
  box { <0, 0, -2>, <2, 2, 2> pigment { rgb <0.2, 0.7, 0.2> } }
  pigment { rgb <0.3, 0.4, 0.9> }
  rotate 20 * y
  translate <1, 0.2, 0>
}
difference {
  box { <-0.9, -0.9, -0.9>, <0.9, 0.7, 0.9> }
  mesh { Octahedron(false) inside_vector y scale 1.3 }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate 30 * y
  translate <3.2, 0, 0.4>
}
mesh { Octahedron(false) pigment { rgbf <1, 0.9, 0.5, 0.7> } interior { ior 1.3 } scale 0.7 rotate 20 * y translate <-2.4, -0.2, -2.4> }

// Textures of faces and of corners, inside and outside, open.
mesh {
  triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> texture { Red } }
  triangle { <1, 0, 0>, <1, 1, 0>, <0, 1, 0> texture { Dots } }
  triangle { <1, 0, 0>, <2, 0, 0>, <1, 1, 0> texture_list { Red Dots Glass } }
  smooth_triangle { <2, 0, 0>, <1, 0, -1>, <2, 1, 0>, <1, 1, -1>, <1, 1, 0>, <-1, 1, -1> }
  texture { pigment { rgb <0.7, 0.9, 0.9> } finish { phong 0.8 } }
  interior_texture { pigment { rgb <0.9, 0.2, 0.7> } }
  rotate <10, 15, 0>
  translate <-0.9, -0.9, -2.2>
}
mesh {
  triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
  texture { pigment { rgb <0.7, 0.9, 0.9> } }
  interior_texture { pigment { rgb <0.9, 0.2, 0.7> } }
  hierarchy off
  rotate 190 * y
  translate <2.9, -0.9, -2.2>
}
