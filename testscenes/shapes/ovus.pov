// Eggs: upright and on their heads, with their own coordinates, moved, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.2, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

ovus { 1, 0.6 pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } translate <-3, 0, 0.4> }
ovus { 0.8, 1.1 sturm uv_mapping pigment { checker rgb <0.2, 0.3, 0.7> rgb <1, 0.9, 0.6> scale <1 / 12, 1 / 8, 1> } rotate <20, 30, -20> scale 0.8 translate <-0.6, -0.1, 0.4> }
ovus { 1, 0.3 pigment { rgb <0.8, 0.3, 0.3> } scale <0.7, 1, 1.2> rotate <0, 20, 70> translate <2.6, -0.3, 0.4> }
ovus { 0.6, 0.6 pigment { rgbf <0.6, 1, 0.7, 0.7> } interior { ior 1.2 } translate <-2.2, -0.5, -2> }
difference {
  ovus { 0.8, 0.5 }
  ovus { 0.7, 0.4 }
  box { <0, -2, -2>, <2, 2, 0> }
  pigment { rgb <0.6, 0.5, 0.9> }
  translate <0.2, -0.4, -2>
}
difference {
  box { -0.7, 0.7 }
  ovus { 0.7, 0.5 translate -0.1 * y scale 1.1 }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate 30 * y
  translate <2.4, -0.4, -2>
}
