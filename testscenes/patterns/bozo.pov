// bozo: smooth noise, with each of its generators.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { bozo color_map { [0 rgb <0.2, 0.3, 0.6>][0.5 rgb <0.9, 0.8, 0.5>][1 rgb <0.6, 0.1, 0.1>] } } }
sphere { <-1.4, 0, 0>, 0.9 pigment { bozo scale 0.4 } }
sphere { <0.4, 0, 0.4>, 0.8 pigment { bozo noise_generator 1 color_map { [0.2 rgb 0][0.8 rgb 1] } scale <0.3, 0.6, 0.3> rotate 30 } }
box { <1.3, -1, -0.6>, <2.2, 0.6, 0.6> pigment { bozo noise_generator 3 triangle_wave frequency 2 phase 0.3 scale 0.5 } }
