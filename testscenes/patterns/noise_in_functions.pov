// Patterns in functions go by the scene's noise generator.
#version 3.7;
global_settings { assumed_gamma 1 noise_generator 3 }
#include "functions.inc"
#default { finish { ambient 1 diffuse 0 } }
camera { orthographic location -z look_at 0 right 4*x up 3*y }
#declare Bozo = function { pattern { bozo scale 0.3 } }
#declare Paint = function { pigment { granite scale 0.5 color_map { [0.3 rgb x] [0.7 rgb <0, 1, 1>] } } }
box { <-2, -1.5, 0>, <0, 0, 1> pigment { function { Bozo(x, y, z) } } }
box { <0, -1.5, 0>, <2, 0, 1> pigment { function { Paint(x, y, z).green } } }
box { <-2, 0, 0>, <0, 1.5, 1> pigment { function { f_noise3d(3*x, 3*y, z) } } }
box { <0, 0, 0>, <2, 1.5, 1> pigment { bozo scale 0.3 } }
