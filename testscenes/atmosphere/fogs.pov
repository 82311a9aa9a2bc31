// Several fogs at once: constant and of the ground, filtering, turned, seen in mirrors and through glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2, -8> look_at <0, 0.5, 0> right x*4/3 angle 50 }
light_source { <-14, 16, -16> rgb 1 }
background { rgb <0.2, 0.3, 0.6> }
fog { distance 40 rgbft <0.6, 0.5, 0.4, 0.3, 0.1> }
fog { fog_type 2 distance 6 rgbt <0.8, 0.9, 1, 0.2> fog_offset 0.2 fog_alt 0.6 up <0.2, 1, 0> }
fog { fog_type 2 distance 9 color rgb <0.9, 0.6, 0.7> fog_offset -0.4 fog_alt 0.3 turbulence <0.3, 0.1, 0.3> turb_depth 0.4 octaves 3 omega 0.6 lambda 2.2 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.2 } }
sphere { <-1.8, 0.1, 0>, 1 pigment { rgb 0.1 } finish { reflection 0.8 ambient 0 diffuse 0.1 } }
sphere { <0.7, 0, -1>, 0.8 pigment { rgbf <0.9, 0.95, 1, 0.9> } interior { ior 1.2 } finish { phong 0.7 } }
cylinder { <2.6, -1, 2>, <2.6, 3, 2>, 0.4 pigment { rgb <0.8, 0.3, 0.2> } }
cylinder { <5, -1, 12>, <5, 6, 12>, 0.9 pigment { rgb <0.3, 0.8, 0.2> } }
