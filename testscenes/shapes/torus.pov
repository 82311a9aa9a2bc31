// Tori: lying, standing, thick so that the hole closes, thin, and scaled without proportion.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

torus { 0.8, 0.25 translate <-1.2, -0.6, 0> pigment { rgb <0.9, 0.3, 0.2> } finish { specular 0.5 } }
torus { 0.7, 0.2 rotate 90*x rotate 30*y translate <1.3, 0.1, 0> pigment { rgb <0.2, 0.6, 0.9> } }
torus { 0.3, 0.4 rotate 30*x translate <0, 0.9, 0.5> pigment { rgb <0.9, 0.8, 0.2> } }
torus { 0.6, 0.03 rotate <60, 0, 20> translate <0, -0.3, -1.6> pigment { rgb <0.3, 0.9, 0.4> } }
torus { 1, 0.3 scale <0.4, 0.8, 0.7> rotate <-40, 0, 30> translate <-1.3, 1.1, 0.5> pigment { rgb <0.7, 0.4, 0.9> } }
