// colors.inc: its colours by name, and its macros that turn hue, saturation, value and lightness to colours.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.05 }
camera { location -10*z look_at 0 right x*4/3 angle 36 }
#default { finish { ambient 1 diffuse 0 } }

#include "colors.inc"
#macro Swatch(Column, Row, Colour)
  box { <-0.27, -0.27, 0>, <0.27, 0.27, 0.1> translate <0.62*Column - 2.8, 1.6 - 0.62*Row, 0> pigment { Colour } }
#end
#declare Colours = array[30] {
  Red, Green, Blue, Yellow, Cyan, Magenta, White, Gray50, Orange, Brown,
  Aquamarine, BlueViolet, Coral, DarkGreen, Firebrick, ForestGreen, Gold, HuntersGreen, IndianRed, Khaki,
  LightBlue, Maroon, NavyBlue, Orchid, Pink, Plum, SkyBlue, SummerSky, Turquoise, Wheat
}
#for (I, 0, 29) Swatch(mod(I, 10), int(I/10), color Colours[I]) #end
#for (I, 0, 9) Swatch(I, 3, rgb CHSV2RGB(<36*I, 0.8, 0.9>)) #end
#for (I, 0, 9) Swatch(I, 4, rgb CHSL2RGB(<36*I, 0.7, 0.5>)) #end
Swatch(0, 5, color rgb CRGB2HSV(Orange)*<1/360, 1, 1>)
Swatch(1, 5, color Red*0.4 + Blue*0.3)
Swatch(2, 5, color Clear)
