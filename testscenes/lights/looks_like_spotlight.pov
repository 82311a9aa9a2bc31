// What belongs to a spotlight and to an area light; it hides nothing from other lights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> right x*4/3 angle 50 }
light_source { <-3, 4, -2>, rgb 0.9 spotlight point_at <-1, 0, 0> radius 20 falloff 35
  looks_like { cylinder { 0, <0.3, -0.6, 0.2>, 0.3 pigment { rgb 0.4 } finish { ambient 0.5 } } } }
light_source { <2.5, 4, -2>, rgb 0.8 area_light 2*x, 2*z, 3, 3
  looks_like { box { <-1, 0, -1>, <1, 0.1, 1> pigment { rgb <1, 0.95, 0.8> } finish { emission 1 } } rotate 20*z } }
light_source { <0, 7, -2>, rgb 0.3 }

plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.55, 0.6> } }
plane { z, 5 pigment { rgb <0.7, 0.75, 0.9> } }
sphere { <-1.2, 1, 0.5>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 phong_size 20 } }
box { <1, 0, -0.5>, <2.2, 1.6, 1> pigment { rgb <0.3, 0.7, 0.9> } finish { specular 0.4 } }
cylinder { <0, 0, -2>, <0, 1.3, -2>, 0.25 pigment { rgb <0.6, 0.9, 0.3> } }
