// The camera that POV-Ray has before anything is said of it, only moved: at the origin, looking along z, right 4/3.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

camera { translate <0.07, 0.53, -6.1> }

sphere { <0, 0, 0>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
box { <1.5, -1, -0.5>, <2.5, 1.5, 0.5> pigment { rgb <0.3, 0.7, 0.9> } }
cone { <-2, -1, 0>, 0.7, <-2, 1.2, 0>, 0 pigment { rgb <0.6, 0.9, 0.3> } }
sphere { <0, 1.2, 3>, 0.7 pigment { rgb <0.9, 0.8, 0.3> } }
