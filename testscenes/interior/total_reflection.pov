// Total internal reflection: a prism of glass, a ball inside a box, and a slab seen along its side.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

intersection {
  plane { -y, 0.8 } plane { <1, 1, 0>, 0.4 } plane { <-1, 1, 0>, 0.4 } plane { z, 0.8 } plane { -z, 0.8 }
  rotate 30*y
  translate <-1.2, 0, 0>
  pigment { rgbt <0.95, 1, 1, 0.95> }
  finish { diffuse 0 specular 0.3 }
  interior { ior 1.6 }
}
box { <0.4, -0.9, -0.5>, <1.9, 0.6, 0.5> rotate -25*y pigment { rgbf <0.9, 0.95, 1, 0.95> } finish { diffuse 0 } interior { ior 1.9 } }
sphere { <1.1, -0.2, 0.5>, 0.3 pigment { rgb <0.9, 0.3, 0.2> } }
box { <-1, -0.98, -2.6>, <1, -0.8, -1.6> pigment { rgbf <0.7, 1, 0.8, 0.9> } finish { diffuse 0.1 } interior { ior 1.5 } }
