// Curves of all kinds that are swept, straight and to a tip, with holes, open, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -11> look_at <0, 0, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

prism { linear_sweep linear_spline -0.8, 0.4, 10, <-1, -1>, <1, -1>, <1, 1>, <0, 0.4>, <-1, 1>, <-1, -1>, <-0.5, -0.6>, <0.5, -0.6>, <0, 0>, <-0.5, -0.6>
  pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } translate <-3.6, 0, 1> }
prism { quadratic_spline -0.6, 0.6, 7, <-1, 0.8>, <-0.8, -0.8>, <0.8, -0.8>, <0.9, 0.7>, <0, 0.2>, <-0.9, 0.7>, <-0.8, -0.8>
  pigment { rgb <0.4, 0.7, 0.9> } rotate <-40, 20, 0> translate <-1.2, 0, 1> }
prism { cubic_spline -0.6, 0.6, 14,
  <-1, 0.8>, <-0.8, -0.8>, <0.8, -0.8>, <0.9, 0.7>, <-0.9, 0.7>, <-0.8, -0.8>, <0.8, -0.8>,
  <-0.4, 0.4>, <-0.4, -0.4>, <0.4, -0.4>, <0.4, 0.4>, <-0.4, 0.4>, <-0.4, -0.4>, <0.4, -0.4>
  sturm pigment { rgb <0.8, 0.3, 0.3> } rotate <20, 30, 0> translate <1.3, 0, 1> }
prism { bezier_spline -0.5, 0.5, 8, <-0.8, 0>, <-0.8, 1.2>, <0.8, 1.2>, <0.8, 0>, <0.8, 0>, <0.8, -1.2>, <-0.8, -0.4>, <-0.8, 0>
  open pigment { rgb <0.3, 0.7, 0.3> } interior_texture { pigment { rgb <0.9, 0.3, 0.8> } } rotate <-50, 0, 20> translate <3.7, 0, 1> }
prism { conic_sweep linear_spline 0.2, 1, 5, <-1, -1>, <1, -1>, <0.7, 1>, <-1, 0.6>, <-1, -1>
  pigment { rgb <0.9, 0.6, 0.3> } rotate 180 * x translate <-3.4, 0.3, -2.4> }
prism { conic_sweep cubic_spline 0.1, 0.8, 7, <-1, 0.8>, <-0.8, -0.8>, <0.8, -0.8>, <0.9, 0.7>, <-0.9, 0.7>, <-0.8, -0.8>, <0.8, -0.8>
  open pigment { rgb <0.5, 0.8, 0.8> } interior_texture { pigment { rgb <0.9, 0.7, 0.2> } } rotate <-60, 0, 0> scale <1, 1.4, 1> translate <-1.2, -0.6, -2.2> }
difference {
  prism { linear_spline -0.5, 0.5, 4, <-0.9, -0.7>, <0.9, -0.7>, <0, 0.9>, <-0.9, -0.7> }
  prism { bezier_spline -1, 1, 4, <0, -0.5>, <0.9, 0.3>, <-0.9, 0.3>, <0, -0.5> }
  pigment { rgb <0.6, 0.5, 0.9> }
  rotate <-30, 20, 0>
  translate <1.2, -0.4, -2.6>
}
intersection {
  sphere { <0, 0.5, 0>, 0.9 }
  prism { conic_sweep quadratic_spline 0, 2, 7, <-1, 0.8>, <-0.8, -0.8>, <0.8, -0.8>, <0.9, 0.7>, <0, 0.2>, <-0.9, 0.7>, <-0.8, -0.8> inverse }
  pigment { rgb <0.9, 0.6, 0.8> }
  translate <3.4, -0.6, -2.6>
}
