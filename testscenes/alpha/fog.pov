// What shows through fogs that let something through at any distance.
#version 3.7;
global_settings { assumed_gamma 1 }
fog { distance 30 rgbft <0.5, 0.6, 0.7, 0.3, 0.4> }
fog { fog_type 2 distance 10 fog_offset -0.5 fog_alt 0.4 rgbt <0.9, 0.6, 0.3, 0.2> }
camera { location <0, 1, -6> look_at 0 }
light_source { <5, 5, -9> rgb 1 }
sphere { <-1.5, 0, 0>, 1 hollow pigment { rgbf <0.9, 0.5, 0.3, 0.6> } }
sphere { <0, 0.7, 2>, 1 pigment { rgbt <0.9, 0.5, 0.3, 0.6> } }
sphere { <1.5, 0, 0>, 1 pigment { rgb <0.2, 0.5, 0.3> } finish { reflection 0.4 } }
