// How fast many of a kind are traced, see docs/performance.md. A sphere with noise on it.
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3.2> look_at 0 angle 50 }
light_source { <4, 6, -8> rgb 1 }
isosurface {
  function { sqrt(x*x + y*y + z*z) - 0.9 + 0.25 * f_noise3d(4*x, 4*y, 4*z) }
  threshold 0
  max_gradient 3
  contained_by { sphere { 0, 1.2 } }
  pigment { rgb <0.9, 0.7, 0.4> } finish { phong 0.4 }
}
