// As many sources of waves and ripples as the scene says.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

global_settings { number_of_waves 3 }
Ball(0, 0, texture { pigment { ripples color_map { Map } frequency 3 } })
Ball(1, 0, texture { pigment { waves color_map { Map } frequency 5 } })
plane { y, -1 pigment { rgb <0.3, 0.5, 0.6> } normal { waves 0.6 frequency 2 scale <0.5, 1, 0.3> } finish { reflection 0.3 } }
