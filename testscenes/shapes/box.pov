// Boxes: corners in either order, rotated, scaled without proportion, thin.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

box { <-1.9, -1, -0.6>, <-0.9, 0.6, 0.6> pigment { rgb <0.9, 0.3, 0.2> } }
box { <0.5, 0.5, 0.5>, <-0.5, -0.5, -0.5> rotate <30, 40, 10> translate <0.4, -0.1, -0.5> pigment { rgb <0.2, 0.6, 0.9> } }
box { -1, 1 scale <0.2, 0.9, 0.4> rotate -25*y translate <1.7, -0.1, 0> pigment { rgb <0.4, 0.8, 0.3> } }
box { <-0.5, 1.2, 0>, <1.8, 1.23, 0.4> pigment { rgb <0.9, 0.9, 0.4> } }
