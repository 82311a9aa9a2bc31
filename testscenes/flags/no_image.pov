// no_image: not seen by the camera, but in mirrors and through glass, and it casts its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

box { <-3, -1, 1.6>, <3, 2, 1.8> pigment { rgb 0.05 } finish { ambient 0 diffuse 0 reflection 0.9 } }

sphere { <-1.5, 0, 0>, 0.6 no_image pigment { rgb <0.9, 0.3, 0.2> } }
sphere { <0.2, 0, -0.6>, 0.6 pigment { rgbt 0.9 } finish { diffuse 0 } interior { ior 1.3 } }
box { <-0.3, -0.4, 0.3>, <0.6, 0.5, 0.6> no_image pigment { rgb <0.3, 0.7, 0.9> } }
sphere { <1.6, 0, 0>, 0.6 pigment { rgb <0.4, 0.9, 0.3> } }
