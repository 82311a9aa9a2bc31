// Curves of all kinds, with radii that change, closed ones, moved, stretched, cut, cutting and of glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4.5, -11> look_at <0, 0.1, 0> angle 48 }
light_source { <-5, 9, -8> rgb 0.9 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

sphere_sweep { linear_spline 4, <-0.8, -0.8, 0>, 0.3, <0.7, -0.5, 0.2>, 0.15, <-0.4, 0.4, -0.2>, 0.35, <0.6, 0.9, 0>, 0.05 pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } translate <-3.8, 0, 0.4> }
sphere_sweep {
  cubic_spline 6, <-1.2, -1, 0>, 0.2, <-0.8, -0.6, 0>, 0.2, <0.6, -0.6, 0.4>, 0.3, <-0.5, 0.5, 0>, 0.15, <0.7, 0.8, -0.2>, 0.25, <1, 1, 0>, 0.2
  pigment { rgb <0.4, 0.7, 0.9> } finish { phong 0.4 }
  translate <-1.3, 0, 0.4>
}
sphere_sweep {
  b_spline 7, <-1, -1, 0>, 0.3, <-0.8, -0.8, 0>, 0.3, <1, -0.8, 0.5>, 0.2, <1, 0.6, 0>, 0.35, <-0.9, 0.8, 0.3>, 0.1, <-0.9, 0.2, -0.5>, 0.3, <0.3, 0.1, -1>, 0.2
  tolerance 0.001
  pigment { gradient y color_map { [0.5 rgb <0.3, 0.7, 0.3>] [0.5 rgb <1, 0.9, 0.6>] } scale 0.4 }
  translate <1.2, 0, 0.4>
}
// A closed ring of many parts, stretched.
#declare Ring = sphere_sweep {
  b_spline 15,
  #for (I, 0, 14) <cos(I * pi / 6), 0.2 * sin(I * pi / 2), sin(I * pi / 6)>, 0.2 + 0.1 * sin(I * pi / 2)  #end
}
object { Ring scale <1, 1.6, 1> rotate -30 * x pigment { rgb <0.9, 0.4, 0.3> } translate <3.7, 0, 0.4> }
difference {
  object { Ring scale 0.9 }
  box { <0, -2, -2>, <2, 0.05, 2> }
  pigment { rgb <0.6, 0.5, 0.9> }
  rotate <-20, 30, 0>
  translate <-2.8, -0.4, -2.7>
}
difference {
  box { -0.8, 0.8 }
  sphere_sweep { linear_spline 3, <-1, 0, -0.9>, 0.2, <0.2, 0.4, -0.7>, 0.4, <0.6, -1, -0.9>, 0.1 }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate <0, 25, 0>
  translate <0, -0.4, -2.8>
}
sphere_sweep {
  cubic_spline 5, <-1, 0, 0>, 0.3, <-0.7, 0, 0>, 0.3, <0, 0.5, 0>, 0.4, <0.7, 0, 0>, 0.3, <1, -1, 0>, 0.3
  pigment { rgbt <0.7, 0.9, 0.8, 0.8> } finish { phong 0.8 } interior { ior 1.3 }
  translate <2.8, -0.5, -2.8>
}
