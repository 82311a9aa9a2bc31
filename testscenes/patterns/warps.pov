// Warps around a point, an axis, a ring, a plane and a cube.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

#declare P = pigment { checker rgb 0.2, rgb <0.9, 0.8, 0.3> scale <0.06, 0.1, 0.1> }
Ball(0, 0, texture { pigment { P warp { spherical } } })
Ball(1, 0, texture { pigment { P warp { spherical orientation y dist_exp 1 } rotate 30*x } })
Ball(2, 0, texture { pigment { P warp { cylindrical } } })
Ball(3, 0, texture { pigment { P warp { cylindrical orientation x dist_exp 0.5 } } })
Ball(0, 1, texture { pigment { P warp { toroidal major_radius 0.5 } } })
Ball(1, 1, texture { pigment { P warp { toroidal orientation y dist_exp 1 major_radius 0.4 } } })
Ball(2, 1, texture { pigment { gradient <1, 2, 3> color_map { Map } scale 0.2 warp { planar y, 0.3 } } })
Ball(3, 1, texture { pigment { P warp { cubic } rotate 20 } })
plane { z, 2 pigment { bozo color_map { Map } scale 0.2 warp { planar } } }
