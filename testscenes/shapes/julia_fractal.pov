// Both algebras, functions of all kinds, slices, precisions, placements, and what is made of several shapes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -12> look_at <0, 0, 0> angle 75 }
light_source { <-5, 10, -9> rgb 0.9 }
light_source { <8, 5, -9> rgb 0.4 }
plane { y, -1.6 pigment { checker rgb 0.8 rgb 0.6 } }
#macro Show(I, K) scale 0.85 translate <2.4 * I, 0, 2.6 * K> #end

julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 15 pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } Show(-2, 0.4) }
julia_fractal { <-0.2, 0.6, 0.2, 0.2> quaternion cube max_iteration 6 precision 20 pigment { rgb <0.4, 0.7, 0.9> } rotate 40 * y Show(-1, 0.4) }
julia_fractal { <-0.162, 0.163, 0.56, -0.599> hypercomplex sqr max_iteration 8 precision 20 slice <0, 0, 0.3, 1>, 0.1 pigment { rgb <0.5, 0.9, 0.5> } Show(0, 0.4) }
julia_fractal { <-0.6, 0.2, 0, 0> hypercomplex cube max_iteration 8 precision 30 pigment { rgb <0.9, 0.4, 0.3> } Show(1, 0.4) }
julia_fractal { <0.6, 0.2, 0.1, 0> hypercomplex reciprocal max_iteration 6 precision 10 scale 0.4 pigment { rgb <0.8, 0.6, 0.9> } Show(2, 0.4) }
julia_fractal { <-1.4, 0.1, 0.2, 0> hypercomplex exp max_iteration 6 precision 10 scale 0.3 pigment { rgb <0.9, 0.8, 0.6> } Show(-1.6, -0.7) }
julia_fractal { <0.3, 0.5, 0, 0> hypercomplex sin max_iteration 6 precision 10 scale 0.3 pigment { rgb <0.6, 0.8, 0.8> } Show(-0.6, -0.7) }
// With a whole power the set is that of the square, as another function finds it.
julia_fractal { <-0.16, 0.16, 0.5, -0.4> hypercomplex pwr(2, 0) max_iteration 6 precision 20 pigment { rgb <0.9, 0.6, 0.8> } Show(0.4, -0.7) }
difference {
  julia_fractal { <-0.745, 0, 0.113, 0.05> max_iteration 7 precision 20 }
  plane { z, -0.1 }
  pigment { rgb <0.7, 0.7, 0.4> }
  rotate -20 * y
  Show(1.6, -0.7)
}
