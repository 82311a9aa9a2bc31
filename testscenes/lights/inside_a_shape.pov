// A light inside an opaque ball lights nothing outside; one inside a glass ball does.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.1, 0.15, 0.25> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

light_source { <-1.2, 0, 0>, rgb 1 }
light_source { <1.3, 0.3, 0>, rgb <1, 0.8, 0.4> }
light_source { <0, 5, -6>, rgb 0.3 }

sphere { <-1.2, 0, 0>, 0.7 pigment { rgb 0.9 } }
sphere { <1.3, 0.3, 0>, 0.6 pigment { rgbt <1, 0.9, 0.7, 0.6> } }
box { <-0.2, -1, -0.5>, <0.2, 0.2, 0.5> pigment { rgb <0.4, 0.7, 0.9> } }
