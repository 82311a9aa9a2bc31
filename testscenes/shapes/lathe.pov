// Curves of all kinds that are turned, with their own coordinates, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -11> look_at <0, 0.2, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }
#declare Checks = pigment { checker rgb <0.2, 0.3, 0.7> rgb <1, 0.9, 0.6> scale <1 / 12, 1 / 8, 1> }

lathe { linear_spline 6, <0, -1>, <0.9, -1>, <0.4, 0>, <0.8, 0.9>, <0.6, 0.9>, <0, 0> pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } translate <-3.8, 0, 0.4> }
lathe { quadratic_spline 6, <0.2, -1.4>, <0.3, -1>, <0.9, -0.3>, <0.5, 0.2>, <0.9, 0.7>, <0.3, 1> pigment { rgb <0.4, 0.7, 0.9> } rotate <30, 0, 20> translate <-1.3, 0, 0.4> }
lathe { cubic_spline 7, <0.3, -1.5>, <0, -1>, <0.9, -0.6>, <0.4, 0>, <0.8, 0.6>, <0, 1>, <-0.5, 1.2> sturm uv_mapping pigment { Checks } translate <1.1, 0, 0.2> }
lathe {
  bezier_spline 8, <0.5, -0.7>, <1.1, -0.7>, <1.1, 0.6>, <0.5, 0.6>, <0.5, 0.6>, <0.2, 0.6>, <0.2, -0.7>, <0.5, -0.7>
  pigment { rgb <0.3, 0.7, 0.3> }
  rotate -30 * x
  translate <3.6, 0, 0.4>
}
// Open ones show their inside.
lathe { cubic_spline 5, <1, -1.3>, <0.3, -0.8>, <0.6, -0.2>, <0.9, 0.4>, <0.9, 0.9> pigment { rgb <0.9, 0.4, 0.3> } interior_texture { pigment { uv_mapping Checks } } rotate -40 * x translate <-2.8, -0.2, -2.8> }
difference {
  lathe { linear_spline 5, <0, -0.8>, <0.9, -0.6>, <0.9, 0.4>, <0.6, 0.7>, <0, 0.7> }
  lathe { bezier_spline 4, <0, -0.5>, <0.9, -0.4>, <0.7, 0.4>, <0, 1> }
  box { <0, 0, -2>, <2, 2, 2> }
  pigment { rgb <0.6, 0.5, 0.9> }
  rotate 70 * y
  translate <0, -0.35, -2.7>
}
difference {
  box { -0.8, 0.8 }
  lathe { quadratic_spline 6, <0.2, -1.2>, <0, -0.9>, <0.7, -0.5>, <0.3, 0>, <0.7, 0.5>, <0, 1> }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate <0, 30, 0>
  translate <2.7, -0.4, -2.8>
}
