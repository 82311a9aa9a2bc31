// transform: declared and used again, several in one block, and the inverse of one.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Turn = transform { rotate 30*z scale <1, 0.6, 1> translate <1.2, 0.2, 0> }
#declare Twice = transform { Turn transform { Turn } scale 0.6 }
#declare Die = union { box { -0.35, 0.35 } cone { 0.35*y, 0.2, 0.9*y, 0 } }
object { Die pigment { rgb <0.8, 0.8, 0.8> } }
object { Die transform { Turn } pigment { rgb <0.9, 0.3, 0.2> } }
object { Die transform Twice pigment { rgb <0.3, 0.7, 0.9> } translate <-0.3, 0.5, 0.6> }
object { Die transform { Turn inverse } pigment { rgb <0.6, 0.9, 0.3> } }
object { Die transform { Turn } transform { Turn inverse } scale 0.6 translate <0, -0.6, -1.4> pigment { rgb <0.9, 0.8, 0.3> } }
