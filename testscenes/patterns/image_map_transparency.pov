// Light through pictures: alpha, filter and transmit of all colours and of single ones, shown once; and its shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }

#macro Panel(I, J, P) box { <-0.95, -0.7, 0>, <0.95, 0.7, 0.1> pigment { P translate <-0.5, -0.5, 0> scale <1.8, 1.3, 1> } translate <I*2 - 2, 0.75 - J*1.5, 0> } #end
Panel(0, 0, pigment { image_map { png "images/rgba.png" interpolate 2 } })
Panel(1, 0, pigment { image_map { gif "images/palette.gif" filter 0, 0.8 transmit 2, 0.7 filter 5, 1 } })
Panel(2, 0, pigment { image_map { png "images/rgb.png" filter all 0.3 transmit all 0.4 } })
Panel(0, 1, pigment { image_map { png "images/palette.png" } scale 0.5 })
Panel(1, 1, pigment { image_map { gif "images/palette.gif" once transmit all 0.5 } scale 0.6 translate 0.2 })
Panel(2, 1, pigment { image_map { png "images/rgba.png" premultiplied on interpolate 2 } })
plane { z, 1.5 pigment { checker rgb 0.9 rgb 0.6 scale 0.4 } }
