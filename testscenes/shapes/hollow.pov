// hollow changes nothing by itself where there is no medium; transparent spheres with and without it, one with ior.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { <-1.3, 0, 0>, 0.9 hollow pigment { rgbt <0.9, 0.7, 0.7, 0.7> } finish { phong 0.4 } }
sphere { <1.3, 0, 0>, 0.9 pigment { rgbt <0.7, 0.9, 0.7, 0.7> } finish { phong 0.4 } }
sphere { <0, 0.1, -1.2>, 0.5 hollow on pigment { rgbf <0.8, 0.8, 1, 0.9> } interior { ior 1.3 } }
box { <-0.4, 0.9, 0>, <0.4, 1.5, 0.4> hollow off pigment { rgb <0.9, 0.8, 0.2> } }
