// Repeated blocks, moved and mirrored.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { wood color_map { Map } warp { repeat 0.5*x } scale 0.5 } })
Ball(1, 0, texture { pigment { gradient <1, 1, 0> color_map { Map } warp { repeat 0.4*x flip x } warp { repeat 0.3*y offset <0.1, 0, 0> } } })
Ball(2, 0, texture { pigment { spherical color_map { Map } translate 0.5 warp { repeat x flip <1, 1, 0> } warp { repeat y flip y offset 0.3*x } scale 0.4 } })
Ball(3, 0, texture { pigment { rgb 0.8 } normal { spherical 1 translate 0.5 warp { repeat x } warp { repeat y } warp { repeat z } scale 0.3 } })
plane { z, 2 pigment { leopard color_map { Map } scale 0.1 warp { repeat 1.3*x offset 0.2*y } } }
