// Textures by the numbers of a palette, and by how red pixels are.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }

#declare R = texture { pigment { rgb <0.8, 0.2, 0.1> } finish { reflection 0.3 } }
#declare G = texture { pigment { checker rgb <0.2, 0.7, 0.2> rgb <0.4, 1, 0.4> scale 0.1 } }
#declare B = texture { pigment { rgbt <0.2, 0.3, 0.9, 0.6> } }
#declare Y = texture { pigment { rgb <0.8, 0.8, 0.2> } normal { bumps 0.8 scale 0.1 } finish { specular 0.6 } }
box { <-2.9, 0.1, 0>, <-0.1, 2, 0.1> texture { material_map { gif "images/palette.gif" texture { R } texture { G } texture { B } texture { Y } texture { R } } scale <2.8, 1.9, 1> translate <-2.9, 0.1, 0> } }
box { <0.1, 0.1, 0>, <2.9, 2, 0.1> texture { material_map { gif "images/palette.gif" interpolate 2 texture { R } texture { G } texture { B } } scale <2.8, 1.9, 1> translate <0.1, 0.1, 0> } }
box { <-2.9, -2, 0>, <-0.1, -0.1, 0.1> texture { material_map { png "images/rgb.png" texture { R } texture { G } texture { B } texture { Y } } scale <2.8, 1.9, 1> translate <-2.9, -2, 0> } }
sphere { <1.5, -1, 0>, 0.9 texture { material_map { gif "images/palette.gif" map_type 1 once texture { Y } texture { G } texture { B } } } }
plane { z, 2 pigment { checker rgb 0.2 rgb 0.5 scale 0.3 } }
