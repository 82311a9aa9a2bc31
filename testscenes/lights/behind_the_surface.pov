// Lights that graze a surface and lights behind it, on planes, triangles and a sphere seen from inside.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.1, 0.15, 0.25> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

light_source { <0, -0.98, 3>, rgb 1 }
light_source { <-6, 0.2, 0>, rgb <1, 0.4, 0.2> }

triangle { <-2, -1, 1>, <0, -1, 1.5>, <-1, 1.5, 1> pigment { rgb 0.9 } }
sphere { <1.4, 0, 0>, 0.9 clipped_by { plane { z, 0 inverse } } pigment { rgb <0.8, 0.9, 0.5> } }
plane { -z, -6 pigment { rgb 0.6 } }
