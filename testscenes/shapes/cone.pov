// Cones: pointed, cut, upside down, open, and one whose radii are equal.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

cone { <-1.8, -1, 0>, 0.7, <-1.8, 0.9, 0>, 0 pigment { rgb <0.9, 0.5, 0.1> } }
cone { <-0.4, -1, 0>, 0.3, <-0.4, 0.4, 0>, 0.6 open pigment { rgb <0.3, 0.6, 0.9> } }
cone { <0.9, -1, 0>, 0.6, <0.9, 0.2, 0>, 0.25 pigment { rgb <0.8, 0.2, 0.5> } }
cone { <1.9, 0.7, 0>, 0.2, <2.2, -0.8, -0.9>, 0.45 pigment { rgb <0.4, 0.8, 0.4> } }
cone { <0.2, 1.3, 0>, 0.25, <1.4, 1.5, 0>, 0.25 pigment { rgb <0.9, 0.9, 0.4> } }
