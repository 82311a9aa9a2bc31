// Refraction: balls and boxes of several indices, filter and transmit, and a lens.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { <-1.5, 0, 0>, 0.8 pigment { rgbt <1, 1, 1, 0.9> } finish { phong 0.6 diffuse 0.1 } interior { ior 1.5 } }
box { -0.6, 0.6 rotate <0, 30, 0> translate <0.2, -0.35, 0> pigment { rgbf <0.8, 1, 0.9, 0.9> } finish { diffuse 0.1 } interior { ior 1.33 } }
sphere { <1.7, 0, 0>, 0.8 pigment { rgbf <1, 0.9, 0.6, 0.95> } finish { diffuse 0 } interior { ior 0.8 } }
intersection { sphere { -0.5*z, 0.7 } sphere { 0.5*z, 0.7 } translate <0, 0.6, -2> pigment { rgbt 0.95 + 0.05*z } interior { ior 1.8 } }
box { <-3, -1, 3>, <3, 1.5, 3.2> pigment { checker rgb <0.9, 0.3, 0.2>, rgb <0.9, 0.9, 0.6> scale 0.4 } }
