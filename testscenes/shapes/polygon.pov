// Flat surfaces between lines: with holes, tilted, with textures on both sides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.2, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> pigment { gradient x scale 0.5 } rotate <20, 30, 0> translate <-2.8, 0.4, 0> }
#declare P = polygon {
  12,
  <0, 0>, <0, 6>, <4, 6>, <4, 3>, <1, 3>, <1, 0>, <0, 0>,
  <1, 4>, <1, 5>, <3, 5>, <3, 4>, <1, 4>
  scale 0.35
}
object { P pigment { rgb <1, 0.8, 0.3> } finish { phong 0.5 } interior_texture { pigment { rgb <0.3, 0.4, 0.9> } } translate <-1, -1, 0> }
object { P pigment { rgb <1, 0.8, 0.3> } interior_texture { pigment { rgb <0.3, 0.4, 0.9> } } rotate 200 * y translate <2.2, -1, 0.4> }
polygon { 4, <0, 0, 0>, <1, 0.5, 1>, <0.2, 1.4, 0.3>, <0, 0, 0> pigment { rgbf <0.6, 1, 0.7, 0.6> } translate <2.2, -0.8, -0.5> }
// A star whose lines cross.
polygon { 6, #for (I, 0, 5) <sin(I * 4 * pi / 5), cos(I * 4 * pi / 5), 0> #if (I < 5) , #end #end
  pigment { rgb <0.9, 0.3, 0.3> } rotate <60, 10, 0> translate <0.4, -0.9, -2> }
