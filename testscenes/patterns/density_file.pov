// Densities of files of 8, 16 and 32 bits, interpolated and not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { density_file df3 "images/grid8.df3" color_map { Map } translate -0.5 scale 1.5 } })
Ball(1, 0, texture { pigment { density_file df3 "images/grid8.df3" interpolate 1 color_map { Map } translate -0.5 scale 1.5 } })
Ball(2, 0, texture { pigment { density_file df3 "images/grid8.df3" interpolate 2 color_map { Map } translate -0.5 scale 1.5 } })
Ball(3, 0, texture { pigment { density_file df3 "images/grid16.df3" color_map { Map } translate -0.5 scale 1.5 } })
Ball(0, 1, texture { pigment { density_file df3 "images/grid16.df3" interpolate 1 color_map { Map } translate -0.5 } })
Ball(1, 1, texture { pigment { density_file df3 "images/grid32.df3" interpolate 2 color_map { Map } translate -0.5 scale 1.5 } })
Ball(2, 1, texture { pigment { density_file df3 "images/grid32" interpolate 0 color_map { Map } translate -0.5 scale 1.5 } })
plane { z, 2 pigment { checker rgb 0.2 rgb 0.5 } }
