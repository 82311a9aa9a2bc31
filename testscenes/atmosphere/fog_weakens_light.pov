// A light that fogs weaken, in the open, through glass that is hollow and that is not, and one that they do not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.5, 0> angle 60 }
light_source { <5, 12, -6> rgb 2 media_attenuation on }
light_source { <-15, 10, -6> rgb <0.3, 0.2, 0.1> }
light_source { <5, 6, 9> rgb <0.2, 0.4, 0.6> media_attenuation on media_interaction off }
fog { distance 18 rgb <0.6, 0.65, 0.7> }
fog { fog_type 2 distance 6 rgb 0.6 fog_alt 0.5 }
sphere { <-1.5, 1.2, 0>, 1.1 pigment { rgbf <1, 0.8, 0.8, 0.9> } hollow }
sphere { <1.5, 1.2, 0>, 1.1 pigment { rgbf <1, 0.8, 0.8, 0.9> } }
sphere { <0, 0.4, -2>, 0.4 pigment { rgb <0.8, 0.4, 0.3> } }
plane { y, 0 pigment { checker rgb 0.5 rgb 0.8 } hollow }
