// Surfaces of the fourth degree.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -7> look_at <0, 0.2, 0> angle 40 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

// A ring with radii 0.9 and 0.3: (x^2 + y^2 + z^2 + K)^2 - 4 R (x^2 + z^2)
#declare R = 0.81; #declare K = 0.81 - 0.09;
#declare Ring = quartic {
  <1, 0, 0, 0, 2, 0, 0, 2, 0, 2 * K - 4 * R, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 2 * K, 0, 0, 0, 0, 1, 0, 2 * K - 4 * R, 0, K * K>
}
object { Ring pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } rotate <-50, 0, 20> translate <-1.4, 0.1, 0> }
difference {
  box { -0.9, 0.9 }
  object { Ring scale <0.9, 1.6, 0.9> }
  pigment { rgb <0.5, 0.8, 0.6> }
  rotate <-25, 35, 0>
  translate <1.5, -0.1, 0>
}
