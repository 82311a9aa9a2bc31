// The angle under which a surface is seen.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { aoi color_map { Map } } })
Ball(1, 0, texture { pigment { aoi color_map { Map } frequency 3 } normal { bumps 0.6 scale 0.2 } })
Ball(2, 0, texture { aoi texture_map { [0.6 pigment { rgb y }] [0.8 pigment { rgb x } finish { reflection 0.4 } ] } })
Ball(3, 0, texture { pigment { aoi pigment_map { [0.5 checker scale 0.1] [1 rgb 1] } } })
sphere { <0.5, -0.4, -2.5>, 0.4 pigment { aoi color_map { [0.5 rgbt <1, 0.5, 0.5, 0.9>] [1 rgbf <0.3, 0.9, 0.4, 1>] } } }
plane { y, -1 pigment { aoi color_map { Map } } finish { reflection 0.3 } }
