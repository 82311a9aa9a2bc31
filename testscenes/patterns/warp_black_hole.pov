// Black holes: strength, falloff, inverse, repeated, with turbulence.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { checker rgb 0.2, rgb 1 scale 0.15 warp { black_hole <0, 0, -0.7>, 0.6 } } })
Ball(1, 0, texture { pigment { checker rgb 0.2, rgb 1 scale 0.15 warp { black_hole <0, 0, -0.7>, 0.6 strength 2 falloff 1 } } })
Ball(2, 0, texture { pigment { checker rgb 0.2, rgb 1 scale 0.15 warp { black_hole <0, 0, -0.7>, 0.6 inverse strength 3 } } })
Ball(3, 0, texture { pigment { wood color_map { Map } scale 0.3 warp { black_hole <0.3, 0.3, 0.3>, 0.25 falloff 0.5 repeat <0.6, 0.6, 0.6> } } })
plane { z, 2 pigment { checker rgb 0.2, rgb 1 scale 0.25 warp { black_hole <0.5, 0.5, 0.5>, 0.4 repeat <1, 1.2, 0> turbulence <0.2, 0.3, 0.1> strength 1.4 } translate 0.1*z } }
