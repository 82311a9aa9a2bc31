// matrix: a shear, a rotation written as a matrix, and a mirror.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Die = difference { box { -0.5, 0.5 } sphere { <0, 0, -0.5>, 0.3 } cylinder { <0.3, -1, 0>, <0.3, 1, 0>, 0.1 } }
object { Die matrix <1, 0, 0, 0.5, 1, 0, 0, 0.2, 1, -1.4, 0, 0> pigment { rgb <0.9, 0.3, 0.2> } }
#declare C = cos(radians(35));
#declare S = sin(radians(35));
object { Die matrix <C, S, 0, -S, C, 0, 0, 0, 1, 0.2, 0.1, 0> pigment { rgb <0.3, 0.7, 0.9> } }
object { Die rotate 30*y matrix <-1, 0, 0, 0, 0.6, 0, 0, 0, 1, 1.5, -0.2, -0.4> pigment { rgb <0.6, 0.9, 0.3> } }
