// Patterns that divide space into cells of two to six kinds.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -100> look_at 0 right x*4/3 angle 6 }
#default { finish { ambient 1 diffuse 0 } }
#macro Tile(Column, Row, Pigment)
  box { <-0.96, -0.96, 0>, <0.96, 0.96, 0.1> pigment { Pigment } translate <2 * Column - 3, 2 - 2 * Row, 0> }
#end
Tile(0, 0, pigment { brick scale 0.12 })
Tile(1, 0, pigment { brick rgb 0.9, rgb <0.6, 0.2, 0.1> brick_size <0.7, 0.3, 0.5> mortar 0.06 })
Tile(2, 0, pigment { cubic })
Tile(3, 0, pigment { hexagon rotate 90*x scale 0.3 })
Tile(0, 1, pigment { square rotate 90*x scale 0.3 })
Tile(1, 1, pigment { triangular rotate 90*x scale 0.5 })
Tile(2, 1, pigment { hexagon rgb 1, rgb 0.5, rgb <0.2, 0.3, 0.4> rotate 90*x scale 0.25 translate 0.1*y })
Tile(3, 1, pigment { triangular rgb 1, rgb 0.8, rgb 0.6, rgb 0.4 rotate 90*x scale 0.4 rotate 20*z })
Tile(0, 2, pigment { square rgb x, rgb y, rgb z, rgb 1 rotate 90*x scale 0.2 rotate 30*z })
Tile(1, 2, pigment { cubic rgb 1, rgb 0.5 rotate <30, 40, 0> })
Tile(2, 2, pigment { brick scale 0.1 rotate <20, 30, 40> })
Tile(3, 2, pigment { checker scale 0.3 })
