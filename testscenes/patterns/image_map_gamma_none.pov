// As image_map_gamma, of an old scene that says nothing of gamma.
#version 3.6;
global_settings { }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
#macro Panel(I, J, P) box { <-0.7, -0.7, 0>, <0.7, 0.7, 0.1> pigment { P translate <-0.5, -0.5, 0> scale 1.3 } finish { ambient 1 diffuse 0 } translate <I*1.5 - 2.25, 0.75 - J*1.5, 0> } #end
Panel(0, 0, pigment { image_map { png "images/rgb.png" } })
Panel(1, 0, pigment { image_map { png "images/rgb_gama.png" } })
Panel(2, 0, pigment { image_map { png "images/grey.png" } })
Panel(3, 0, pigment { image_map { png "images/grey16.png" interpolate 2 } })
Panel(0, 1, pigment { image_map { ppm "images/rgb.ppm" } })
Panel(1, 1, pigment { image_map { gif "images/palette.gif" } })
Panel(2, 1, pigment { image_map { png "images/rgb.png" gamma 1.5 } })
Panel(3, 1, pigment { image_map { hdr "images/light.hdr" } })

