// Maps and lists of textures: finishes, normals and clear parts between them; average; in layers and in glass.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 texture { checker texture { pigment { rgb 0.8 } finish { reflection 0.3 } } texture { pigment { bozo scale 0.2 } normal { bumps 0.5 scale 0.1 } } } }
sphere { <-1.4, 0, 0>, 0.9 texture { gradient y texture_map {
  [0.3 pigment { rgb <0.8, 0.3, 0.2> } normal { bumps 0.8 scale 0.1 } finish { phong 0.8 }]
  [0.7 pigment { rgbf <0.9, 1, 0.9, 0.8> } finish { reflection 0.4 }] } scale 1.2 } interior { ior 1.3 } }
sphere { <0.4, 0, 0.4>, 0.8 texture { average texture_map { [1 pigment { rgb x } finish { ambient 0.3 }][2 pigment { checker rgb 0, rgb 1 scale 0.2 } normal { wrinkles 0.5 scale 0.2 }] } rotate 30 } }
box { <1.3, -1, -0.6>, <2.2, 0.6, 0.6> texture { brick texture { pigment { rgb 0.8 } } texture { bozo texture_map { [0.4 pigment { rgb <0.7, 0.2, 0.2> }][0.6 pigment { rgb <0.3, 0.1, 0.1> } finish { specular 0.8 } normal { dents 1 scale 0.1 }] } scale 0.2 } scale 0.08 } }
