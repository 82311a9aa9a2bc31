// rotate: about each axis, about all three in the order x, y, z, and after a translation about the origin.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Arrow = union { cylinder { 0, 0.7*y, 0.08 } cone { 0.7*y, 0.2, 1.1*y, 0 } box { <-0.3, -0.05, -0.1>, <0.3, 0.05, 0.1> } }
object { Arrow rotate 50*x translate <-2, 0, 0> pigment { rgb <0.9, 0.3, 0.2> } }
object { Arrow rotate 50*y translate <-1, 0, 0> pigment { rgb <0.3, 0.7, 0.9> } }
object { Arrow rotate 50*z translate <0.3, 0, 0> pigment { rgb <0.6, 0.9, 0.3> } }
object { Arrow rotate <30, 60, -40> translate <1, 0, 0> pigment { rgb <0.9, 0.8, 0.3> } }
object { Arrow translate 1.2*x rotate 40*y rotate -30*z translate <0.6, 0, 0.6> pigment { rgb <0.7, 0.4, 0.9> } }
