// Pigments, normals and textures averaged, with weights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end
Ball(0, 0, texture { pigment { average pigment_map { [1 checker scale 0.2] [2 granite color_map { Map }] } } })
Ball(1, 0, texture { pigment { rgb 0.8 } normal { average normal_map { [1 bumps 0.8 scale 0.1] [0.5 wrinkles 0.6 scale 0.3] } } })
Ball(2, 0, texture { average texture_map { [1 pigment { rgb <0.8, 0.2, 0.2> } finish { reflection 0.5 }] [2 pigment { marble color_map { Map } scale 0.3 }] } })
Ball(3, 0, texture { pigment { average pigment_map { [1 gradient x color_map { Map } scale 0.3] [1 gradient y color_map { Map } scale 0.4] } turbulence 0.3 } })
plane { z, 2 pigment { average pigment_map { [1 rgb 0.2] [3 cells] } } }
