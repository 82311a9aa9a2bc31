// Glass in water in glass: the index to leave by is that of what is around.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { 0, 1 pigment { rgbt 0.95 } finish { diffuse 0 } interior { ior 1.5 } }
sphere { 0, 0.8 pigment { rgbt <0.9, 0.95, 1, 0.95> } finish { diffuse 0 } interior { ior 1.33 } }
sphere { <0.1, -0.1, -0.1>, 0.3 pigment { rgbf <1, 0.8, 0.8, 0.9> } finish { diffuse 0 } interior { ior 2 } }
box { <1.3, -0.97, -0.4>, <2.1, 0.3, 0.4> pigment { rgbf <0.8, 1, 0.8, 0.9> } interior { ior 1.4 } }
cylinder { <1.7, -1, 0>, <1.7, 0.9, 0>, 0.2 pigment { rgb <0.9, 0.3, 0.3> } }
box { <-2.5, -1, 2>, <2.5, 1, 2.2> pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.5> scale 0.3 } }
