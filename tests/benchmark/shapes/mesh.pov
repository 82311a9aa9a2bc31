// How fast many of a kind are traced, see docs/performance.md. A million triangles: a bumpy sheet.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -1.6> look_at <0, 0, 0.1> angle 55 }
light_source { <-3, 5, -4> rgb 1 }
#declare N = 708;
mesh2 {
  vertex_vectors { N * N
    #for (I, 0, N - 1) #for (J, 0, N - 1)
      , <2 * I / N - 1, 0.06 * sin(I * 0.11) * cos(J * 0.13) + 0.01 * sin(I * 0.9 + J * 0.7), 2 * J / N - 1>
    #end #end
  }
  face_indices { 2 * (N - 1) * (N - 1)
    #for (I, 0, N - 2) #for (J, 0, N - 2)
      , <I * N + J, I * N + J + 1, I * N + N + J>, <I * N + J + 1, I * N + N + J + 1, I * N + N + J>
    #end #end
  }
  pigment { rgb <0.5, 0.8, 0.5> } finish { phong 0.3 }
}
