// Shadows of glass: they let the light through straight, tinted, whatever the index; caustics 1 does not change them.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

light_source { <3, 5, -4>, rgb <0.6, 0.5, 0.5> }
sphere { <-1, 0.2, 0>, 0.7 pigment { rgbf <0.4, 1, 0.5, 0.95> } finish { diffuse 0.1 } interior { ior 1.5 } }
sphere { <1, 0.2, 0>, 0.7 pigment { rgbt <1, 0.4, 0.5, 0.7> } finish { diffuse 0.1 } interior { ior 1.5 fade_distance 1 fade_power 2 fade_color rgb <1, 0.5, 0.5> } }
