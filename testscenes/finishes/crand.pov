// compare: psnr 35
// Grainy surfaces. What chance takes is not what it takes in POV-Ray, which draws in the order in which it shades.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
light_source { <20, 5, -10> rgb <0.4, 0.4, 0.3> }
sphere { <-1.5, 0.5, 0>, 1 pigment { rgb <0.8, 0.4, 0.3> } finish { crand 0.03 } }
sphere { <1.5, 0.5, 0>, 1 pigment { rgb <0.3, 0.4, 0.8> } finish { crand 0.04 specular 0.4 } }
plane { y, -1 pigment { checker rgb 0.3 rgb 0.7 } finish { crand 0.03 reflection 0.2 } }
