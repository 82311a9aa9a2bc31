// What area lights do to layers, mirrors and clear things.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-4, 6, -5>, rgb 0.9 area_light 4*x, 4*z, 4, 4 adaptive 1 }
light_source { <5, 4, -4>, rgb <0.5, 0.4, 0.3> }

plane { y, 0 texture { pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } finish { reflection 0.3 } } texture { pigment { gradient x color_map { [0 rgbt 1] [1 rgbt <0, 0, 1, 0.6>] } } } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 reflection { 0.4 exponent 1.5 } } }
box { <0.6, 0, -0.5>, <1.8, 1.6, 1> pigment { rgbt <0.6, 0.8, 0.9, 0.5> } interior { fade_distance 1 fade_power 2 } }
sphere { <2.6, 1.4, -2>, 0.8 pigment { rgbf <0.9, 0.6, 0.4, 0.7> } interior { ior 1.3 } }
