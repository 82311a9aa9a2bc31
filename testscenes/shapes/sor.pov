// Surfaces of revolution: closed and open, with their own coordinates, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -11> look_at <0, 0.2, 0> angle 44 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }
#declare Checks = pigment { checker rgb <0.2, 0.3, 0.7> rgb <1, 0.9, 0.6> scale <1 / 12, 1 / 8, 1> }
#macro Vase() sor { 7, <0, -1.2>, <0.5, -1>, <0.9, -0.5>, <0.5, 0.2>, <0.3, 0.6>, <0.7, 1>, <1, 1.2> #end

Vase() pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } translate <-3.4, 0, 0.4> }
Vase() open pigment { rgb <0.4, 0.7, 0.9> } interior_texture { pigment { rgb <0.9, 0.3, 0.3> } } rotate <-40, 0, 10> translate <-1.1, 0, 0.4> }
Vase() sturm uv_mapping pigment { Checks } rotate <30, 20, 0> translate <1.3, 0, 0.4> }
sor { 5, <0.4, -1.4>, <0, -1>, <0.8, 0>, <0, 1>, <0.4, 1.3> pigment { rgbf <0.6, 1, 0.7, 0.6> } interior { ior 1.2 } translate <3.6, 0, 0.4> }
difference {
  Vase() }
  box { <0, -2, -2>, <2, 2, 0> }
  pigment { rgb <0.6, 0.5, 0.9> }
  scale 0.8 rotate 20 * y
  translate <-1.6, -0.4, -2.8>
}
difference {
  box { -0.8, 0.8 }
  sor { 6, <0.3, -1.4>, <0.6, -1>, <0.2, -0.2>, <0.5, 0.4>, <0.6, 1>, <0.3, 1.2> }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate <0, 30, 0>
  translate <1.6, -0.4, -2.8>
}
