// turbulence, as a word and as a warp, and where a pattern puts it to a use of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> turbulence 0.3 } }
sphere { <-1.4, 0, 0>, 0.9 pigment { marble turbulence 0.8 scale 0.4 } }
sphere { <0.4, 0, 0.4>, 0.8 pigment { wood turbulence <0.2, 0.4, 0.1> octaves 4 omega 0.7 lambda 2.5 scale 0.2 rotate <30, 20, 0> } }
sphere { <-0.5, -0.5, -1.2>, 0.45 pigment { gradient y warp { turbulence <0.5, 0.2, 0.5> octaves 3 } scale 0.3 warp { turbulence 0.1 } } }
sphere { <0.6, -0.5, -1.3>, 0.45 pigment { spiral1 3 turbulence 0.4 scale 0.3 } }
sphere { <1.2, 0.9, 1>, 0.5 pigment { spiral2 2 turbulence 0.2 scale 0.3 rotate x*70 } }
box { <1.3, -1, -0.6>, <2.2, 0.6, 0.6> pigment { onion turbulence 0.5 scale 0.3 } }
