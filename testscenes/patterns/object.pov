// Inside and outside of objects.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

#declare O = difference { sphere { 0, 0.75 } box { -0.45, 0.45 } cylinder { -z, z, 0.2 } }
Ball(0, 0, texture { pigment { object { O rgb <0.8, 0.3, 0.2>, rgb <0.2, 0.3, 0.9> } } })
Ball(1, 0, texture { pigment { object { box { -0.5, 0.5 rotate 30 } pigment { checker scale 0.1 } pigment { granite } } } })
Ball(2, 0, texture { object { torus { 0.6, 0.25 rotate 70*x } texture { pigment { rgb 0.9 } } texture { pigment { rgb 0.2 } finish { reflection 0.4 } } } })
Ball(3, 0, texture { pigment { rgb 0.8 } normal { object { sphere { <0, 0, -0.7>, 0.4 } } 0.3 } })
plane { y, -1 pigment { object { union { cylinder { -5*y, 5*y, 1 } plane { x, -2 } } rgb 0.3, rgb <0.7, 0.6, 0.2> } } }
