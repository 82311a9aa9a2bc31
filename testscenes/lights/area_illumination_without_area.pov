// A light that was to light by its area and has none shines on surfaces from behind as well, through clear ones.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.2, 1.5, -4> look_at 0 }
light_source { <4, 3, 6> rgb 0.9 area_illumination }
light_source { <-4, 3, -6> rgb 0.3 }
plane { y, -1 pigment { checker rgb 0.7, rgb 0.3 } }
sphere { <-0.6, 0, 0>, 1 pigment { rgbt <1, 0.8, 0.6, 0.5> } finish { phong 0.5 } }
box { <0.6, -1, -1>, <1.8, 0.4, 0> pigment { rgbt <0.6, 0.8, 1, 0.4> } normal { bumps 0.5 scale 0.1 } }
