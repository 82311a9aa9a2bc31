// background, with a colour that is partly transparent.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

background { color rgbt <0.8, 0.4, 0.2, 0.3> }
sphere { <0, 0, 0>, 0.9 pigment { rgbt <0.8, 0.9, 1, 0.6> } }
