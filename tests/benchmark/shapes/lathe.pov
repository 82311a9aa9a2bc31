// How fast many of a kind are traced, see docs/performance.md. Vases: lathes of cubic and quadratic splines.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -11> look_at <0, 0.5, 0> angle 50 }
light_source { <-6, 14, -10> rgb 1 }
#declare Cubic = lathe { cubic_spline 8 <0.3, -0.2> <0.4, 0> <0.7, 0.5> <0.35, 1> <0.3, 1.3> <0.5, 1.6> <0.55, 1.7> <0.6, 1.8> }
#declare Quadratic = lathe { quadratic_spline 6 <0, -0.2> <0.4, 0> <0.7, 0.6> <0.3, 1.2> <0.5, 1.6> <0.6, 1.7> }
#for (I, -3, 3)
  #for (J, -2, 2)
    object { #if (mod(I + J + 10, 2) = 0) Cubic #else Quadratic #end
      pigment { rgb <0.7, 0.5 + 0.1 * J, 0.6 + 0.1 * I> } finish { phong 0.5 } translate <I * 1.5, 0, J * 1.5> }
  #end
#end
plane { y, 0 pigment { rgb 0.7 } }
