// Intersections: a lens, a rounded die, a wedge of half spaces, and a difference inside.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

intersection {
  sphere { -0.6*x, 1 pigment { rgb <0.9, 0.3, 0.2> } }
  sphere { 0.6*x, 1 pigment { rgb <0.2, 0.5, 0.9> } }
  rotate 40*y
  translate <-1.7, 0, 0>
}
intersection {
  box { -0.6, 0.6 }
  sphere { 0, 0.8 }
  pigment { rgb <0.9, 0.9, 0.8> }
  rotate <20, 35, 0>
  translate <0, -0.3, 0>
}
intersection {
  plane { y, 0.4 } plane { -y, 0.9 } plane { x, 0.5 } plane { -x, 0.4 } plane { z, 0.4 } plane { <-0.3, 0.2, -1>, 0.5 }
  difference { sphere { 0, 2 } cylinder { -3*z, 3*z, 0.25 } }
  pigment { rgb <0.4, 0.8, 0.5> }
  translate <1.6, 0, 0>
}
