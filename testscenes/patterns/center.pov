// Patterns that depend on the way from the origin, from an axis or a plane.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -100> look_at 0 right x*4/3 angle 6 }
#default { finish { ambient 1 diffuse 0 } }
#macro Tile(Column, Row, Pigment)
  box { <-0.96, -0.96, 0>, <0.96, 0.96, 0.1> pigment { Pigment } translate <2 * Column - 3, 2 - 2 * Row, 0> }
#end
Tile(0, 0, pigment { boxed })
Tile(1, 0, pigment { cylindrical rotate 90*x })
Tile(2, 0, pigment { planar })
Tile(3, 0, pigment { spherical })
Tile(0, 1, pigment { onion scale 0.3 color_map { [0 rgb <1, 0.9, 0.5>] [1 rgb <0.3, 0.1, 0.4>] } })
Tile(1, 1, pigment { leopard scale 0.1 })
Tile(2, 1, pigment { radial rotate 90*x })
Tile(3, 1, pigment { quilted scale 0.5 translate 0.2*z })
Tile(0, 2, pigment { quilted control0 0 control1 2 scale 0.4 translate 0.1*z })
Tile(1, 2, pigment { spherical frequency 3 sine_wave })
Tile(2, 2, pigment { boxed triangle_wave color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } })
Tile(3, 2, pigment { radial frequency 6 rotate 90*x })
