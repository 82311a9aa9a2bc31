// Where no ray leads, all shows through.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgbt <0.2, 0.4, 0.6, 0.4> }
camera { fisheye angle 140 location <0, 0, -3> look_at 0 }
light_source { <5, 5, -9> rgb 1 }
sphere { <-1, 0, 0>, 1 pigment { rgbf <0.9, 0.5, 0.3, 0.6> } }
torus { 1.4, 0.3 pigment { rgbt <0.2, 0.5, 0.3, 0.3> } finish { reflection 0.3 } translate x }
