// One value a cell.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { cells color_map { Map } scale 0.2 } })
Ball(1, 0, texture { pigment { cells color_map { Map } scale 0.3 rotate 30 } })
Ball(2, 0, texture { pigment { cells color_map { Map } turbulence 0.3 scale 0.3 } })
Ball(3, 0, texture { pigment { cells color_map { Map } frequency 3 scale 0.2 } })
Ball(0, 1, texture { pigment { rgb 0.8 } normal { cells 0.6 scale 0.3 } })
plane { y, -0.9 pigment { cells color_map { Map } } }
