// Rings of different width about several points, as a normal and as a pigment.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { waves color_map { Map } frequency 3 } })
Ball(1, 0, texture { pigment { waves color_map { Map } frequency 5 phase 0.3 turbulence 0.2 sine_wave } })
Ball(2, 0, texture { pigment { rgb 0.8 } normal { waves 0.8 frequency 10 } })
Ball(3, 0, texture { pigment { rgb 0.8 } normal { waves 0.5 scale 0.2 phase 0.5 } })
plane { y, -1 pigment { rgb <0.3, 0.5, 0.6> } normal { waves 0.6 frequency 2 scale <0.5, 1, 0.3> } finish { reflection 0.3 } }
