// clipped_by leaves a shape open: the inside is seen; a clip by a plane, by a sphere turned inside out, and bounded_by { clipped_by }.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { 0, 0.9 clipped_by { plane { z, 0 inverse rotate 30*y } } pigment { rgb <0.9, 0.4, 0.2> } translate <-1.4, 0, 0> }
box {
  -0.7, 0.7
  clipped_by { sphere { <0, 0.3, -0.7>, 0.7 inverse } }
  bounded_by { clipped_by }
  pigment { rgb <0.3, 0.7, 0.9> }
  rotate -20*y
  translate <1.3, 0, 0>
}
torus { 0.5, 0.2 clipped_by { plane { y, 0 } plane { x, 0.2 } } rotate 50*x pigment { rgb <0.7, 0.9, 0.3> } translate <0, 0.2, -1> }
