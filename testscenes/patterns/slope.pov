// Slope, with ranges, altitudes, to a point; of tilted surfaces.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { slope y color_map { Map } } })
Ball(1, 0, texture { pigment { slope { <1, 1, -0.5>, 0.3, 0.8 } color_map { Map } } })
Ball(2, 0, texture { pigment { slope { y, 0.1, 0.9 altitude 2*x, -0.7, 0.7 } color_map { Map } } })
Ball(3, 0, texture { pigment { slope { point_at <0, 0, -3> } color_map { Map } } })
Ball(0, 1, texture { pigment { slope -z color_map { Map } frequency 2 } normal { bumps 0.6 scale 0.2 } })
Ball(1, 1, texture { slope y texture_map { [0.5 pigment { rgb x }] [0.6 pigment { slope x color_map { Map } }] } })
Ball(2, 1, texture { pigment { slope y color_map { Map } rotate 60*z scale 2 } })
Ball(3, 1, texture { pigment { slope y color_map { [0.3 rgbt <1, 0.5, 0.5, 0.9>] [0.7 rgbf <0.3, 0.9, 0.4, 1>] } } })
plane { y, -1.6 pigment { slope y color_map { Map } } normal { dents 1 scale 0.5 } }
