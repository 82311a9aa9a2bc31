// Form, metric, offset, solid, and as a normal.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

Ball(0, 0, texture { pigment { crackle color_map { Map } scale 0.3 } })
Ball(1, 0, texture { pigment { crackle form <1, 0, 0> color_map { Map } scale 0.3 } })
Ball(2, 0, texture { pigment { crackle form <0.3, -0.5, 0.7> metric 1 color_map { Map } scale 0.3 } })
Ball(3, 0, texture { pigment { crackle metric 3.5 offset 0.1 color_map { Map } scale 0.3 } })
Ball(0, 1, texture { pigment { crackle solid color_map { Map } scale 0.3 } })
Ball(1, 1, texture { pigment { rgb 0.8 } normal { crackle 0.5 scale 0.3 } })
Ball(2, 1, texture { pigment { crackle offset 0.2 turbulence 0.3 color_map { Map } scale 0.3 } })
Ball(3, 1, texture { pigment { crackle metric 1 offset 0.2 noise_generator 3 solid color_map { Map } scale 0.3 } })
plane { z, 2 pigment { crackle color_map { Map } } }
