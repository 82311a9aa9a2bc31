// Magnetic sets of both types.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end
Ball(0, 0, texture { pigment { magnet 1 mandel 20 color_map { Map } scale 0.3 } })
Ball(1, 0, texture { pigment { magnet 1 mandel 20 color_map { Map } frequency 3 phase 0.2 sine_wave turbulence 0.3 scale 0.3 rotate 30 } })
Ball(2, 0, texture { pigment { rgb 0.8 } normal { magnet 1 mandel 20 0.6 scale 0.3 rotate 20*z } finish { specular 0.3 } })
Ball(3, 0, texture { magnet 1 mandel 20 texture_map { [0.4 pigment { rgb <0.2, 0.6, 0.3> } finish { reflection 0.3 }] [0.6 pigment { checker rgb 0.3, rgb 1 scale 0.2 }] } scale 0.3 })
Ball(0, 1, texture { pigment { magnet 2 mandel 20 color_map { Map } scale 0.3 } })
Ball(1, 1, texture { pigment { magnet 1 julia <0.3, 0.4>, 20 color_map { Map } scale 0.3 } })
plane { z, 2 pigment { magnet 1 mandel 20 pigment_map { [0.3 rgb 0.2] [0.7 granite color_map { Map }] } } }
