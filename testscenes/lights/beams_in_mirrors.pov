// Beams on what is tilted, layered and clear, seen in a mirror.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-4, 5, -4>, rgb 0.9 spotlight point_at <-1, 0, 0> radius 15 falloff 25 }
light_source { <4, 5, -5>, rgb <0.7, 0.8, 0.9> parallel point_at <1, 0.5, 0> }
light_source { <0, 6, -4>, rgb 0.8 cylinder radius 2 falloff 3 point_at <1, 0, 1> }

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } normal { bumps 0.3 scale 0.4 } finish { reflection 0.3 } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 metallic } }
box { <0.6, 0, -0.5>, <1.8, 1.6, 1> texture { pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } } texture { pigment { gradient y color_map { [0 rgbt 1] [1 rgb <1, 1, 0>] } } } }
sphere { <2.6, 1.4, -2>, 0.8 pigment { rgbf <0.9, 0.6, 0.4, 0.7> } interior { ior 1.3 } }
