// fade_distance, fade_power and fade_color: glass that takes light away with the way through it.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

box { <-2, -0.9, -0.8>, <-0.8, 0.7, 0.8> pigment { rgbt 1 } finish { diffuse 0 reflection 0.1 } interior { ior 1.3 fade_distance 0.8 fade_power 1 fade_color rgb <0.2, 0.7, 0.5> } }
sphere { <0.2, -0.2, 0>, 0.8 pigment { rgbf 1 } finish { diffuse 0 } interior { ior 1.4 fade_distance 0.5 fade_power 2 fade_color <0.9, 0.4, 0.2> } }
cone { <1.8, -0.9, 0>, 0.7, <1.8, 0.9, 0>, 0.1 pigment { rgbt 1 } interior { fade_distance 0.4 fade_power 1001 fade_colour rgb <0.3, 0.4, 0.9> } }
sphere { <0.9, -0.6, -1.6>, 0.35 pigment { rgbt 1 } interior { ior 1.2 fade_distance 0.3 fade_power 2 } }
