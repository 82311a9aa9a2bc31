// translate: by a vector, by a number (all three axes), and several in a row.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { 0, 0.4 translate <-1.5, 0.2, 0> pigment { rgb <0.9, 0.3, 0.2> } }
box { -0.3, 0.3 translate 0.7 pigment { rgb <0.3, 0.7, 0.9> } }
cone { 0, 0.4, y, 0 translate x translate -0.8*y translate -z*0.5 pigment { rgb <0.6, 0.9, 0.3> } }
torus { 0.4, 0.1 translate -0.6*y translate <0, 0, -1.2> pigment { rgb <0.9, 0.8, 0.3> } }
