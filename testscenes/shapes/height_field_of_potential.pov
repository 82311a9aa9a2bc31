// A continuous potential: heights of 16 bits in a picture with a palette, lower bytes in its right half.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 1, -1> look_at <0.5, 0.1, 0.5> angle 50 }
light_source { <3, 5, -2>, 1 }
height_field { pot "mtmand.pot" smooth pigment { rgb <0.8, 0.7, 0.5> } }
