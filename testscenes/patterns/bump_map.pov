// Bumps of pictures, by colour and by index, interpolated, laid round, once.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }

#macro Panel(I, J, N) box { <-0.95, -0.7, 0>, <0.95, 0.7, 0.1> pigment { rgb <0.8, 0.7, 0.5> } finish { specular 0.4 } normal { N translate <-0.5, -0.5, 0> scale <1.8, 1.3, 1> } translate <I*2 - 2, 0.75 - J*1.5, 0> } #end
Panel(0, 0, normal { bump_map { png "images/grey.png" bump_size 2 interpolate 2 } })
Panel(1, 0, normal { bump_map { gif "images/palette.gif" use_index bump_size 0.3 } })
Panel(2, 0, normal { bump_map { png "images/rgb.png" bump_size 3 interpolate 3 repeat <2, 2> } })
Panel(0, 1, normal { bump_map { png "images/rgba.png" once bump_size 1.5 interpolate 4 } scale 0.6 })
sphere { <0, -0.75, -0.5>, 0.8 pigment { rgb <0.5, 0.7, 0.8> } normal { bump_map { png "images/grey16.png" map_type 1 bump_size 4 interpolate 2 } } finish { reflection 0.3 } }
Panel(2, 1, normal { bump_map { pgm "images/grey.pgm" gamma 2.2 bump_size 3 } rotate 30*z })
