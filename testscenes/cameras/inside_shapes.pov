// The camera inside a transparent sphere and inside a box that is cut open.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

camera { location <0, 1, -5> look_at <0, 0.3, 0> right x*4/3 }
sphere { <0, 1, -5>, 1 hollow pigment { rgbt <0.9, 1, 0.9, 0.8> } finish { ambient 0.2 } }
light_source { <0, 2.5, -4>, rgb 0.7 }
difference { box { -12, 12 } box { <-3, -2, -10>, <3, 3, 6> } pigment { rgb 0.7 } }

sphere { <0, 0, 0>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
box { <1.5, -1, -0.5>, <2.5, 1.5, 0.5> pigment { rgb <0.3, 0.7, 0.9> } }
