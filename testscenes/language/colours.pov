// Colours: rgb to srgbft, parts by name, arithmetic, promotion, and colours that are declared again.
// compare: share 99.9
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.05 }
camera { location -10*z look_at 0 right x*4/3 angle 36 }
#default { finish { ambient 1 diffuse 0 } }

#macro Swatch(Column, Row, Colour)
  box { <-0.42, -0.35, 0>, <0.42, 0.35, 0.1> translate <Column - 2, 1.5 - 0.8*Row, 0> pigment { Colour } }
#end
#declare A = rgb <0.8, 0.4, 0.1>;
#declare B = color red 0.2 blue 0.9;
Swatch(0, 0, A) Swatch(1, 0, B) Swatch(2, 0, rgb A*0.5) Swatch(3, 0, A + B*0.3) Swatch(4, 0, color rgb (A + B)/2)
Swatch(0, 1, rgb 0.4) Swatch(1, 1, rgb x) Swatch(2, 1, rgb <0.2, 0.8, 0.4>*A) Swatch(3, 1, rgb 1 - A) Swatch(4, 1, rgb A.green)
Swatch(0, 2, rgbf <0.9, 0.2, 0.2, 0.5>) Swatch(1, 2, rgbt <0.2, 0.9, 0.2, 0.5>) Swatch(2, 2, color A filter 0.3) Swatch(3, 2, color A transmit 0.7) Swatch(4, 2, color rgb A red 0.1)
Swatch(0, 3, srgb <0.8, 0.4, 0.1>) Swatch(1, 3, srgb 0.5) Swatch(2, 3, srgbft <0.2, 0.4, 0.9, 0.2, 0.2>) Swatch(3, 3, rgb <A.blue, A.red, A.green>) Swatch(4, 3, color green 0.6)
#declare C = <0.3, 0.6, 0.9>;
Swatch(0, 4, rgb C) Swatch(1, 4, rgb C*0.5) Swatch(2, 4, rgb vrotate(C, 30*z)) Swatch(3, 4, rgb <C.z, C.y, C.x>) Swatch(4, 4, rgb (A.red > 0.5 ? A : B))
