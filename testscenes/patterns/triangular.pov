// Triangles of six kinds.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end
Ball(0, 0, texture { pigment { triangular rgb <0.8, 0.2, 0.2>, rgb <0.2, 0.7, 0.2>, rgb <0.2, 0.3, 0.9>, rgb <0.9, 0.8, 0.2>, rgb <0.2, 0.8, 0.8>, rgb <0.8, 0.3, 0.8>  scale 0.3 } })
Ball(1, 0, texture { pigment { triangular pigment { granite } pigment { rgb <0.2, 0.7, 0.2> } pigment { rgb <0.2, 0.3, 0.9> } pigment { rgb <0.9, 0.8, 0.2> } pigment { rgb <0.2, 0.8, 0.8> } pigment { rgb <0.8, 0.3, 0.8> }  scale 0.3 rotate 30 } })
Ball(2, 0, texture { pigment { rgb 0.8 } normal { triangular normal { bumps 0.2 scale 0.1 } normal { bumps 0.4 scale 0.1 } normal { bumps 0.6000000000000001 scale 0.1 } normal { bumps 0.8 scale 0.1 } normal { bumps 1.0 scale 0.1 } normal { bumps 1.2 scale 0.1 }  scale 0.3 } })
Ball(3, 0, texture { triangular texture { pigment { rgb <0.8, 0.2, 0.2> } finish { reflection 0.0 } } texture { pigment { rgb <0.2, 0.7, 0.2> } finish { reflection 0.1 } } texture { pigment { rgb <0.2, 0.3, 0.9> } finish { reflection 0.2 } } texture { pigment { rgb <0.9, 0.8, 0.2> } finish { reflection 0.30000000000000004 } } texture { pigment { rgb <0.2, 0.8, 0.8> } finish { reflection 0.4 } } texture { pigment { rgb <0.8, 0.3, 0.8> } finish { reflection 0.5 } }  scale 0.3 })
Ball(0, 1, texture { pigment { rgb 0.8 } normal { triangular 0.3  scale 0.3 } })
plane { y, -1.01 pigment { triangular  scale 0.7 } }
