// Method 3: the surface of a smooth mesh, seen from just above it, laid out by its own coordinates.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
light_source { <-4, 6, -5>, rgb 1 }
#declare Scene = union {
  plane { y, -1.5 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
  sphere { <0, 0.2, 3>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { reflection 0.2 } }
  box { <1.8, -1.5, 2>, <2.8, 1.5, 3> pigment { rgb <0.3, 0.7, 0.9> } }
  cone { <-2.4, -1.5, 3>, 0.8, <-2.4, 1.2, 3>, 0 pigment { rgb <0.6, 0.9, 0.3> } }
}
object { Scene }

#declare N = 10;
#macro Point(I, J) #local R = 1 + 0.2*sin(J); (<R*cos(2*pi*I/N), 0.5*J - 1.2, R*sin(2*pi*I/N)>) #end
#declare Ball = mesh2 {
  vertex_vectors { (N + 1)*5 #for (J, 0, 4) #for (I, 0, N) , Point(I, J) #end #end }
  normal_vectors { (N + 1)*5 #for (J, 0, 4) #for (I, 0, N) , <cos(2*pi*I/N), 0.3*cos(J), sin(2*pi*I/N)> #end #end }
  uv_vectors { (N + 1)*5 #for (J, 0, 4) #for (I, 0, N) , <0.05 + 0.9*I/N, 0.1 + 0.2*J> #end #end }
  face_indices {
    N*8
    #for (J, 0, 3)
      #for (I, 0, N - 1)
        #local K = J*(N + 1) + I;
        , <K, K + 1, K + N + 1>, <K + 1, K + N + 2, K + N + 1>
      #end
    #end
  }
  pigment { gradient y color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.2, 0.9, 0.6>] } scale 0.4 }
  finish { specular 0.4 }
}
object { Ball translate <0.3, 0.2, 1> }
camera {
  mesh_camera { 1 3 mesh2 { Ball translate <0.3, 0.2, 1> } smooth }
  location <0, 0, 0.01>
  direction <0, 0, -1>
}
