// Planes: floor, a slanted wall with a normal that has no unit length, a ceiling, a wall behind, and one turned inside out.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

plane { <1, 0.2, -0.6>*7, -4 pigment { checker rgb <0.8, 0.4, 0.3>, rgb <0.5, 0.2, 0.2> scale 0.7 } }
plane { -y, -4 pigment { rgb <0.5, 0.6, 0.7> } }
plane { z, 9 pigment { gradient y color_map { [0 rgb 0.2] [1 rgb <0.3, 0.7, 0.5>] } scale 2 } }
plane { x, 0 inverse rotate -35*y translate <4, 0, 2> pigment { rgb <0.6, 0.6, 0.2> } }
sphere { 0, 0.8 pigment { rgb 0.8 } }
