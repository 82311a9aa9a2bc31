// bumps as a pattern of colours, and as normals in two layers of a texture.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { bumps color_map { [0 rgb <0.2, 0.3, 0.6>][1 rgb <0.9, 0.8, 0.5>] } } }
sphere { <-1.4, 0, 0>, 0.9 pigment { rgb <0.8, 0.3, 0.2> } normal { bumps 0.8 scale 0.15 } finish { phong 0.6 phong_size 30 } }
sphere { <0.4, 0, 0.4>, 0.8
  texture { pigment { rgb <0.2, 0.5, 0.8> } normal { bumps 0.5 scale 0.3 } finish { specular 0.5 } }
  texture { pigment { checker rgbt <1, 1, 1, 1>, rgbt <1, 0.8, 0.1, 0.3> scale 0.3 } normal { bumps 1.2 scale <0.1, 0.3, 0.1> rotate 40 } finish { specular 0.9 roughness 0.01 } } }
box { <1.3, -1, -0.6>, <2.2, 0.6, 0.6> pigment { rgb 0.7 } normal { bumps 0.4 scale 0.1 no_bump_scale } finish { reflection 0.4 } }
