// A camera that starts in members of a union: each member is of its own matter, or of the union's.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at <0, 0.3, 0> angle 60 }
background { rgb <0.3, 0.3, 0.6> }
light_source { <4, 8, -6>, 1 }
plane { y, -1 pigment { checker rgb 1, rgb <1, 0.4, 0.1> } }
union {
  sphere { <0, 0, -3>, 0.7 pigment { rgbt <1, 0.9, 0.9, 0.9> } interior { ior 1.4 } }
  sphere { <0.3, 0, -3>, 1.1 pigment { rgbt <0.9, 1, 0.9, 0.9> } interior { ior 1.2 } }
  box { <-0.4, -0.4, -3.5>, <0.4, 0.5, -0.4> pigment { rgbt <0.9, 0.9, 1, 0.9> } }
  sphere { <0.6, 0, 0>, 0.5 pigment { rgb <0.2, 0.6, 0.3> } }
  interior { ior 1.1 }
}
