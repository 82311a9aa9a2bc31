// Light that is gathered behind clear matter, by its shape and by its bumps; of the interior and of an old finish.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0, 0.5> angle 55 }
light_source { <4, 10, -3> rgb 1 }
light_source { <-8, 10, 2> rgb <0.3, 0.3, 0.5> }
sphere { <-1.6, 0.9, 0>, 0.8 pigment { rgbf <0.9, 0.95, 1, 0.9> } interior { ior 1.4 caustics 0.7 } }
sphere { <0.4, 0.9, 0>, 0.8 pigment { rgbf <1, 0.8, 0.7, 0.8> } normal { bumps 0.5 scale 0.2 } interior { ior 1.2 caustics 0.3 fade_distance 3 fade_power 1 } }
box { <1.6, 0.1, -0.8>, <2.6, 1.5, 0.6> texture { pigment { rgbt <1, 1, 0.5, 0.7> } } texture { pigment { checker rgbt 1, rgbf <0.5, 1, 0.5, 0.8> scale 0.3 } normal { ripples 0.4 scale 0.2 } } interior { caustics 0.5 } }
sphere { <0.2, 0.4, -1.8>, 0.4 pigment { rgbt 0.9 } finish { caustics 8 } }
plane { y, 0 pigment { checker rgb 0.5 rgb 0.7 } }
