// Cylinders: closed, open so that the inside shows, slanted, and scaled to an ellipse.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

cylinder { <-1.6, -1, 0>, <-1.6, 0.8, 0>, 0.6 pigment { rgb <0.9, 0.5, 0.1> } }
cylinder { <0, -1, 0>, <0, 0.5, 0>, 0.7 open pigment { rgb <0.3, 0.6, 0.9> } }
cylinder { <0.8, 1.2, 0>, <2.1, 0.4, -0.8>, 0.25 pigment { rgb <0.8, 0.2, 0.5> } }
cylinder { -y, y, 1 scale <0.7, 0.3, 0.25> rotate <20, 30, -30> translate <1.6, -0.5, -0.6> pigment { rgb <0.4, 0.8, 0.4> } }
