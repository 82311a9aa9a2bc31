// Spirals, marble and wood without turbulence.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -100> look_at 0 right x*4/3 angle 6 }
#default { finish { ambient 1 diffuse 0 } }
#macro Tile(Column, Row, Pigment)
  box { <-0.96, -0.96, 0>, <0.96, 0.96, 0.1> pigment { Pigment } translate <2 * Column - 3, 1 - 2 * Row, 0> }
#end
Tile(0, 0, pigment { spiral1 3 scale 0.5 })
Tile(1, 0, pigment { spiral2 5 scale 0.5 })
Tile(2, 0, pigment { spiral1 -2 scale 0.3 ramp_wave })
Tile(3, 0, pigment { wood scale 0.4 })
Tile(0, 1, pigment { marble scale 0.5 })
Tile(1, 1, pigment { wood scale 0.2 color_map { [0 rgb <0.8, 0.6, 0.4>] [1 rgb <0.3, 0.2, 0.1>] } })
Tile(2, 1, pigment { marble rotate 30*z scale 0.3 ramp_wave })
Tile(3, 1, pigment { spiral2 4 scale 0.4 scallop_wave })
