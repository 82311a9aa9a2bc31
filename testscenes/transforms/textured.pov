// A transformation after the texture moves the pattern with the shape, one before does not.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Checks = pigment { checker rgb 0.9, rgb <0.7, 0.1, 0.1> scale 0.3 }
box { -0.5, 0.5 pigment { Checks } rotate <20, 40, 30> translate <-1.5, 0, 0> }
box { -0.5, 0.5 rotate <20, 40, 30> translate <0, 0, 0> pigment { Checks } }
sphere { 0, 0.6 pigment { Checks rotate 45*z translate 0.1*x } scale <1, 0.7, 1> rotate 30*x translate <1.4, 0, 0> }
union { sphere { -0.3*x, 0.3 } sphere { 0.3*x, 0.3 pigment { gradient y scale 0.2 } } pigment { Checks } scale <1, 1.5, 1> rotate -30*z translate <0.3, -0.4, -1.6> }
