// A pigment of one colour in every form that a colour can be written.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.1 }
camera { location -10*z look_at 0 right x*4/3 angle 38 }

#declare Teal = rgb <0, 0.5, 0.5>;
#macro Swatch(Column, Row, Pigment)
  box { <-0.42, -0.42, 0>, <0.42, 0.42, 0.1> translate <Column - 2, 1.5 - Row, 0> pigment { Pigment } finish { ambient 1 diffuse 0 } }
#end
Swatch(0, 0, pigment { rgb <0.8, 0.3, 0.1> })
Swatch(1, 0, pigment { color rgb <0.8, 0.6, 0.1> })
Swatch(2, 0, pigment { colour red 0.2 green 0.7 blue 0.9 })
Swatch(3, 0, pigment { color Teal })
Swatch(4, 0, pigment { Teal })
Swatch(0, 1, pigment { rgb 0.5 })
Swatch(1, 1, pigment { color rgb x + 0.3*z })
Swatch(2, 1, pigment { color Teal*1.5 + <0.2, 0, 0> })
Swatch(3, 1, pigment { color red 0.9 })
Swatch(4, 1, pigment { color Teal green 0.9 })
Swatch(0, 2, pigment { rgbf <0.8, 0.3, 0.1, 0.5> })
Swatch(1, 2, pigment { rgbt <0.8, 0.3, 0.1, 0.5> })
Swatch(2, 2, pigment { rgbft <0.8, 0.3, 0.1, 0.3, 0.3> })
Swatch(3, 2, pigment { color rgb <0.8, 0.3, 0.1> filter 0.4 transmit 0.2 })
Swatch(4, 2, pigment { color <0.2, 0.9, 0.3> })
Swatch(0, 3, pigment { color <0.2, 0.9, 0.3, 0.1, 0.4> })
Swatch(1, 3, pigment { color rgb <1.4, -0.3, 0.2> })
Swatch(2, 3, pigment { color blue 0.4 transmit 0.3 })
Swatch(3, 3, pigment { rgb <1, 2, 3>/5 })
Swatch(4, 3, pigment { color rgb pow(0.5, 2.2) })
