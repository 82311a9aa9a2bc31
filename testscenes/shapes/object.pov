// object: a declared shape used again with transformations, a texture of its own, clipping and flags.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Ball = sphere { 0, 0.5 }
#declare Red_Ball = object { Ball pigment { rgb <0.9, 0.2, 0.1> } }
object { Ball pigment { rgb <0.3, 0.6, 0.9> } translate <-1.7, 0, 0> }
object { Red_Ball translate <-0.5, 0, 0> }
object { Red_Ball pigment { rgb <0.9, 0.9, 0.2> } scale <0.6, 1.6, 0.6> translate <0.6, 0, 0> }
object { object { Red_Ball scale 1.3 } clipped_by { plane { y, 0.2 } } rotate 30*x translate <1.6, 0, 0> }
object { Red_Ball no_shadow translate <0, 1.3, 0> }
Ball
sphere { Ball translate <0.3, -0.6, -1.6> pigment { rgb 0.9 } }
