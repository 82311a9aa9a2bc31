// Triangles: seen from both sides, as a fan, edge on, and thin.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

triangle { <-2, -1, 0>, <-0.6, -0.8, -0.5>, <-1.4, 1.2, 0.4> pigment { rgb <0.9, 0.3, 0.2> } }
triangle { <-0.3, -0.9, 0>, <-0.1, 1.1, 0.3>, <1.1, -0.6, -0.4> pigment { rgb <0.2, 0.6, 0.9> } }
#declare N = 9;
#for (I, 0, N - 1)
  triangle {
    <1.6, 0.6, 0>,
    <1.6, 0.6, 0> + vrotate(<0.7, 0, 0.1>, 360*I/N*z),
    <1.6, 0.6, 0> + vrotate(<0.7, 0, -0.2>, 360*(I + 1)/N*z)
    pigment { rgb <I/N, 1 - I/N, 0.5> }
  }
#end
triangle { <0.9, -0.95, -1>, <2.2, -0.95, -0.6>, <2.1, -0.9, -1> pigment { rgb <0.9, 0.9, 0.2> } }
