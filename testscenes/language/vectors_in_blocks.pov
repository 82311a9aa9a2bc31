// Vectors and numbers where the language lets one stand for the other, commas left out, and a trailing comma.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { <0, 0, 0>, 0.6 pigment { rgb <0.9, 0.3 0.2,> } translate -1.5 + <0, 1.5, 1> }
sphere { 0, 0.6 pigment { rgb <0.3, 0.7, 0.9> } translate x*1.4 }
box { -0.4 0.4 pigment { color rgb 0.7 } rotate 30 }
cylinder { -y*0.6, y*0.6 0.2 pigment { rgb y } scale <1, 1, 2> translate <0.4, -0.2, -1.6> }
light_source { 8 - 12*z, 0.4 }
light_source { <-8, 6, 2> color rgb 0.3 shadowless }
