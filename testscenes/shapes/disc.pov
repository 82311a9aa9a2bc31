// Discs: whole, with a hole, seen from behind, and with a normal that has no unit length.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

disc { <-1.3, 0, 0>, <0.4, 0.3, -1>, 0.9 pigment { rgb <0.9, 0.4, 0.2> } }
disc { <0.6, 0, 0>, <0, 5, -2>, 1, 0.45 pigment { rgb <0.3, 0.7, 0.9> } }
disc { <1.6, 1.1, 0.5>, <-1, 0, 2>, 0.7, 0.2 pigment { rgb <0.5, 0.9, 0.3> } }
disc { 0, z, 1, 0.6 scale <0.7, 0.4, 1> rotate -50*x translate <-0.2, 1.4, 0> pigment { rgb <0.9, 0.8, 0.3> } }
