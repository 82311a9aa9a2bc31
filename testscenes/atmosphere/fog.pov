// Constant fogs, with filter and transmit, before objects, mirrors, glass and sky.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at <0, 1, 0> angle 70 }
light_source { <20, 30, -20> rgb 1 }
background { rgb <0.2, 0.4, 0.9> }
fog { distance 12 color rgbft <0.8, 0.6, 0.5, 0.3, 0.2> }
fog { distance 60 rgb <0.4, 0.7, 0.4> }
fog { color rgb 1 }
sphere { <-1.2, 1, 0>, 1 pigment { rgb <0.4, 0.2, 0.2> } finish { reflection { 0.6 } specular 0.5 } }
sphere { <1.2, 1, 0>, 1 pigment { rgbf 0.9 } interior { ior 1.3 } }
sphere { <3, 1, 4>, 1 pigment { rgbf <0.9, 0.6, 0.6, 0.9> } interior { ior 1.2 } hollow }
union { sphere { <-4, 1, 6>, 1 } box { <-5, 0, 6.5>, <-2, 2, 7> hollow off } pigment { rgbt <0.3, 1, 1, 0.7> } hollow }
plane { y, 0 pigment { checker rgb 0.3 rgb 0.6 } finish { reflection 0.2 } }
