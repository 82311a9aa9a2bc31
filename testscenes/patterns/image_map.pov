// Pictures of several formats laid on planes, with each kind of interpolation, repeated and moved.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }

#macro Panel(I, J, P) box { <-0.95, -0.7, 0>, <0.95, 0.7, 0.1> pigment { P translate <-0.5, -0.5, 0> scale <1.8, 1.3, 1> } translate <I*2 - 2, 0.75 - J*1.5, 0> } #end
Panel(0, 0, pigment { image_map { png "images/rgb.png" } })
Panel(1, 0, pigment { image_map { gif "images/palette.gif" interpolate 2 } })
Panel(2, 0, pigment { image_map { ppm "images/rgb.ppm" interpolate 3 } })
Panel(0, 1, pigment { image_map { tga "images/rgb.tga" interpolate 4 repeat <2, 1.5> } rotate 20*z })
Panel(1, 1, pigment { image_map { "images/palette.png" offset <0.3, 0.4> } })
Panel(2, 1, pigment { image_map { png "images/rgb.png" interpolate 2 } warp { turbulence 0.3 } })
