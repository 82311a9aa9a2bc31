// What scenes get away with: empty statements, CSG of one shape, the last camera, a degenerate box, #undef of nothing.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

camera { location <0, 0, -20> look_at 0 }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
#undef Nobody
union { sphere { <-1.5, 0, 0>, 0.7 } pigment { rgb <0.9, 0.3, 0.2> } }
intersection { box { -0.5, 0.5 } pigment { rgb <0.3, 0.7, 0.9> } }
difference { sphere { <1.5, 0, 0>, 0.7 } pigment { rgb <0.6, 0.9, 0.3> } }
union { }
#declare Unused = sphere { 0, 3 }
box { <-0.5, 1, 0>, <0.5, 1, 0.6> pigment { rgb <0.9, 0.8, 0.3> } }
sphere { <0, -0.8, -1.5>, 0.2 pigment { rgb <0.9, 0.3, 0.9> } pigment { rgb <0.3, 0.9, 0.9> } }
