// Patterns of noise, each with the three generators.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end

#declare I = 1;
#while (I < 4)
  Ball(I - 1, 0, texture { pigment { granite noise_generator I color_map { Map } } })
  Ball(I - 1, 1, texture { pigment { wrinkles noise_generator I turbulence 0.3 color_map { Map } scale 0.4 } normal { dents 0.8 noise_generator I scale 0.2 } })
  #declare I = I + 1;
#end
Ball(3, 0, texture { pigment { agate noise_generator 3 color_map { Map } scale 0.5 } })
Ball(3, 1, texture { pigment { marble noise_generator 1 turbulence 1 color_map { Map } scale 0.5 } })
plane { z, 2 pigment { bozo noise_generator 3 color_map { Map } } normal { bumps 0.5 noise_generator 1 } }
