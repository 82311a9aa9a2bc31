// Polynomials given term by term.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -7> look_at <0, 0.2, 0> angle 40 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

polynomial {
  4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, xyz(2, 0, 0): -1.2, xyz(0, 2, 0): -1.2, xyz(0, 0, 2): -1.2, xyz(0, 0, 0): 0.9
  pigment { rgb <0.9, 0.5, 0.4> } finish { phong 0.5 }
  rotate <-10, 35, 0>
  translate <-1.4, 0, 0>
}
intersection {
  sphere { 0, 1.1 }
  polynomial { 5, xyz(5, 0, 0): 1, xyz(0, 1, 0): -0.5, xyz(1, 0, 2): 1.5, xyz(0, 0, 1): 0.2 inverse sturm }
  pigment { rgb <0.4, 0.6, 0.9> }
  translate <1.4, 0, 0>
}
