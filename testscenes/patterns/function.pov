// Functions as patterns and as heights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

#include "functions.inc"
#declare F = function { sin(x*10) * cos(y*8) + z }
#declare P = function { pattern { granite scale 0.5 } }
Ball(0, 0, texture { pigment { function { x + y*y } color_map { Map } } })
Ball(1, 0, texture { pigment { function { F(x, y, z) } color_map { Map } } })
Ball(2, 0, texture { pigment { function { P(x, y, z) * 2 } color_map { Map } triangle_wave } })
Ball(3, 0, texture { pigment { function { f_noise3d(x*5, y*5, z*5) } color_map { Map } scale 0.8 rotate 30 } })
Ball(0, 1, texture { pigment { rgb 0.8 } normal { function { sin(x*30)/2 + 0.5 } 0.4 } })
plane { y, -1 pigment { function { sqrt(x*x + z*z) } color_map { Map } } }
