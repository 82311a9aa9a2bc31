// Pigments by their brightness, as pigments, normals and textures.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { pigment_pattern { granite color_map { Map } scale 0.5 } color_map { [0 rgb x] [1 rgb y] } } })
Ball(1, 0, texture { pigment { rgb 0.8 } normal { pigment_pattern { crackle color_map { Map } scale 0.3 } 0.6 } })
Ball(2, 0, texture { pigment_pattern { checker rgb 0.2, rgb 0.9 scale 0.2 } texture_map { [0.3 pigment { rgb y }] [0.6 pigment { rgb x } finish { reflection 0.4 } ] } })
Ball(3, 0, texture { pigment { pigment_pattern { image_map { png "images/rgb.png" map_type 1 once } } color_map { Map } } })
plane { z, 2 pigment { pigment_pattern { gradient x pigment_map { [0 wood scale 0.3] [1 marble scale 0.4] } } color_map { Map } } }
