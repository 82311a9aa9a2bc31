// Normals of textures that move with their objects: turned, scaled unevenly, sheared, and through maps of textures.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
#declare T = texture { pigment { rgb 0.9 } normal { onion 2 scale 0.24 } finish { phong 0.5 } }
plane { y, 0 texture { T scale <1, 2, 3> rotate x*30 } translate -y }
sphere { 0, 0.9 texture { T } scale <1, 0.6, 0.8> rotate <30, 20, 40> translate <-1.4, 0.2, 0> }
box { -0.6, 0.6 texture { T } rotate <-30, 30, 0> translate <0.3, 0, 0.3> }
cylinder { -0.5*y, 0.5*y, 0.5 texture { gradient y texture_map { [0.3 T][0.7 pigment { rgb <0.8, 0.4, 0.2> } normal { bumps 1 scale <0.1, 0.3, 0.1> }] } }
  matrix <1, 0.3, 0, 0, 1, 0.2, 0.1, 0, 1, 1.7, 0, 0> }
