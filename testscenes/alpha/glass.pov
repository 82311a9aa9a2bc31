// What shows through glass: bent, totally reflected, split, faded, in front of each other.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 1, -6> look_at 0 }
light_source { <5, 5, -9> rgb <1, 0.9, 0.7> }
sphere { <-1.6, 0, 0>, 1 pigment { rgb <0.9, 0.5, 0.3> filter 0.7 }
  interior { ior 1.5 }
  finish { phong 0.7 reflection 0.1 } }
sphere { <0.7, 0.2, 1>, 0.9 pigment { rgbf <0.7, 0.9, 0.8, 0.9> }
  interior { ior 1.3 fade_distance 1 fade_power 2 fade_color <0.2, 0.8, 0.3> } }
box { <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5> rotate <20, 40, 0> translate <1.9, -0.3, -1> pigment { rgbt 1 }
  interior { ior 1.6 } }
cone { <2.5, 0.9, 0>, 0.6, <2.5, 2, 0>, 0 pigment { rgbf <0.9, 0.9, 1, 0.8> }
  interior { ior 1.4 dispersion 1.1 dispersion_samples 5 } }
cylinder { <-1, 1.4, 0>, <1, 1.4, 0.3>, 0.4 open pigment { rgbf <1, 0.2, 0.2, 0.8> } }
plane { y, -1.3 pigment { rgbt <0.3, 0.3, 0.3, 0.3> }
  finish { reflection 0.4 } }
