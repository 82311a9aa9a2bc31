// Surfaces of a polynomial: cubic, quartic, poly of several orders and polynomial, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.5, -11> look_at <0, 0.2, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

// A ring of radii 0.7 and 0.25: (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2)
#declare R = 0.49; #declare K = 0.49 - 0.0625;
quartic {
  <1, 0, 0, 0, 2, 0, 0, 2, 0, 2 * K - 4 * R, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 2 * K, 0, 0, 0, 0, 1, 0, 2 * K - 4 * R, 0, K * K>
  sturm
  pigment { rgb <1, 0.8, 0.3> }
  finish { phong 0.6 }
  rotate <-40, 0, 20>
  translate <-3.6, 0.2, 0>
}
// A cubic: x^3 - 3 x z^2 + ... as a saddle for three legs.
cubic {
  <1, 0, 0, 0, 0, 0, 0, -3, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0>
  clipped_by { sphere { 0, 1.1 } }
  pigment { rgb <0.4, 0.7, 0.9> }
  translate <-1.1, 0, 0.2>
}
poly { 2, <1, 0, 0, 0, 2, 0, 0.3, 1, 0, -0.7> pigment { rgb <0.8, 0.3, 0.3> } translate <1.1, 0, 0> }
poly {
  4, <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -0.4>
  pigment { rgb <0.3, 0.7, 0.3> }
  rotate <20, 30, 0>
  translate <3.4, 0, 0>
}
// (x^2 + 9/4 y^2 + z^2 - 1)^3 - x^2 z^3 - 9/80 y^2 z^3: a heart.
polynomial {
  6,
  xyz(6, 0, 0): 1, xyz(4, 2, 0): 6.75, xyz(4, 0, 2): 3, xyz(4, 0, 0): -3, xyz(2, 4, 0): 15.1875, xyz(2, 2, 2): 13.5,
  xyz(2, 2, 0): -13.5, xyz(2, 0, 4): 3, xyz(2, 0, 3): -1, xyz(2, 0, 2): -6, xyz(2, 0, 0): 3, xyz(0, 6, 0): 11.390625,
  xyz(0, 4, 2): 15.1875, xyz(0, 4, 0): -15.1875, xyz(0, 2, 4): 6.75, xyz(0, 2, 3): -0.1125, xyz(0, 2, 2): -13.5,
  xyz(0, 2, 0): 6.75, xyz(0, 0, 6): 1, xyz(0, 0, 4): -3, xyz(0, 0, 2): 3, xyz(0, 0, 0): -1
  sturm
  pigment { rgb <0.9, 0.2, 0.3> }
  scale 0.7
  rotate <-90, 0, 0>
  rotate 30 * y
  translate <-2.4, -0.4, -2.8>
}
difference {
  box { -0.8, 0.8 }
  poly { 4, <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -0.6> scale 1.05 }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate <0, 30, 0>
  translate <0.2, -0.4, -2.9>
}
intersection {
  sphere { 0, 0.9 }
  polynomial { 3, xyz(3, 0, 0): 1, xyz(0, 1, 0): -0.4, xyz(0, 0, 3): 1 inverse }
  pigment { rgb <0.5, 0.8, 0.8> }
  translate <2.6, -0.3, -2.8>
}
