// scale: evenly, without proportion, negative (a mirror image), and zero, which POV-Ray takes as one.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Mark = union { sphere { 0, 0.5 } cone { 0.3*x, 0.3, 1.1*x, 0 } box { <-0.1, 0, -0.1>, <0.1, 0.9, 0.1> } }
object { Mark scale 0.6 translate <-1.9, 0, 0> pigment { rgb <0.9, 0.3, 0.2> } }
object { Mark scale <0.4, 1.1, 0.8> translate <-0.7, 0, 0> pigment { rgb <0.3, 0.7, 0.9> } }
object { Mark scale <-0.7, 0.7, 0.7> translate <1, 0, 0> pigment { rgb <0.6, 0.9, 0.3> } }
object { Mark scale <0.5, 0, 0.5> translate <1.7, -0.2, 0> pigment { rgb <0.9, 0.8, 0.3> } }
object { Mark scale 0.5 rotate 30*z scale <1, 0.3, 1> translate <-0.2, -0.6, -1.4> pigment { rgb <0.7, 0.4, 0.9> } }
