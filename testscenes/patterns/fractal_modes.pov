// All ways to colour what lies outside and inside of fractals, of each exponent and kind.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 18*x up 14*y }
background { rgb 0.2 }
#default { finish { ambient 1 diffuse 0 } }
#declare Map = color_map { [0 rgb 0] [0.2 rgb <0.9, 0.4, 0>] [0.5 rgb <0.2, 0.3, 1>] [0.8 rgb <0.3, 0.9, 0.4>] [1 rgb 1] }
#macro Tile(Column, Row, Pigment)
  box { -0.97, 0.97 pigment { Pigment color_map { Map } scale 0.55 } translate <2*Column - 8, 6 - 2*Row, 0> }
#end
#declare N = 0;
#while (N < 9)
  Tile(N, 0, pigment { mandel 20 exterior N, 0.4 + 2*(N > 6) interior mod(N, 7), 0.6 })
  Tile(N, 1, pigment { mandel 12 exponent 3 exterior N, 0.4 + 3*(N > 6) interior mod(N + 1, 7), 0.6 })
  Tile(N, 2, pigment { mandel 12 exponent 4 + (N > 4) exterior N, 0.3 + 3*(N > 6) interior mod(N + 2, 7), 0.6 })
  Tile(N, 3, pigment { julia <0.355, 0.33>, 14 exterior N, 0.4 + 2*(N > 6) interior mod(N + 3, 7), 0.9 })
  Tile(N, 4, pigment { julia <0.4, 0.5>, 14 exponent 3 + mod(N, 4) exterior N, 0.2 + 3*(N > 6) interior mod(N + 4, 7), 0.7 })
  Tile(N, 5, pigment { magnet 1 + mod(N, 2) mandel 14 exterior N, 0.02 + 3*(N > 6) interior mod(N + 5, 7), 0.4 })
  Tile(N, 6, pigment { magnet 1 + mod(N, 2) julia <1.2, 0.4>, 14 exterior N, 0.03 + 3*(N > 6) interior mod(N + 6, 7), 0.4 })
  #declare N = N + 1;
#end
