// Mandelbrot's and Julia's sets and magnets, with their ways of colouring.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -100> look_at 0 right x*4/3 angle 6 }
#default { finish { ambient 1 diffuse 0 } }
#macro Tile(Column, Row, Pigment)
  box { <-0.96, -0.96, 0>, <0.96, 0.96, 0.1> pigment { Pigment } translate <2 * Column - 3, 2 - 2 * Row, 0> }
#end
Tile(0, 0, pigment { mandel 30 })
Tile(1, 0, pigment { mandel 20 exponent 3 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } })
Tile(2, 0, pigment { mandel 20 exponent 4 exterior 6, 0.2 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } })
Tile(3, 0, pigment { mandel 12 exponent 5 exterior 7, 4 interior 1, 2 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } })
Tile(0, 1, pigment { julia <0.35, 0.3>, 30 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } })
Tile(1, 1, pigment { julia <0.4, 0.5>, 20 exponent 3 exterior 8, 3 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } })
Tile(2, 1, pigment { julia <0.6, 0.5>, 20 exponent 4 interior 2, 1 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } })
Tile(3, 1, pigment { julia <0.5, 0.55>, 10 exponent 7 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } })
Tile(0, 2, pigment { magnet 1 mandel 20 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } scale 0.4 translate -0.3*x })
Tile(1, 2, pigment { magnet 2 mandel 20 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } scale 0.4 translate -0.3*x })
Tile(2, 2, pigment { magnet 1 julia <1.2, 0.3>, 20 interior 1, 0.5 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } scale 0.4 })
Tile(3, 2, pigment { magnet 2 julia <1.5, 0.4>, 20 exterior 2, 0.01 color_map { [0 rgb 0] [0.3 rgb <1, 0.6, 0>] [0.7 rgb <0.2, 0.3, 1>] [1 rgb 1] } scale 0.4 })
