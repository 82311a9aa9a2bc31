// Pictures as patterns: brightness, alpha, with maps and waves, and as heights of normals.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }

#declare Map = color_map { [0 rgb <0, 0, 0.4>] [0.4 rgb <0.9, 0.3, 0.1>] [0.7 rgb <0.9, 0.9, 0.3>] [1 rgb 1] }
#macro Panel(I, J, P) box { <-0.95, -0.7, 0>, <0.95, 0.7, 0.1> pigment { P translate <-0.5, -0.5, 0> scale <1.8, 1.3, 1> } translate <I*2 - 2, 0.75 - J*1.5, 0> } #end
Panel(0, 0, pigment { image_pattern { png "images/rgb.png" } color_map { Map } })
Panel(1, 0, pigment { image_pattern { png "images/rgba.png" use_alpha interpolate 2 } color_map { Map } })
Panel(2, 0, pigment { image_pattern { png "images/grey.png" interpolate 3 } color_map { Map } frequency 2 triangle_wave })
Panel(0, 1, pigment { image_pattern { gif "images/palette.gif" use_index } color_map { Map } })
Panel(1, 1, pigment { image_pattern { png "images/grey16.png" gamma 2.2 } color_map { Map } })
box { <-0.95, -0.7, 0>, <0.95, 0.7, 0.1> pigment { rgb 0.8 } normal { image_pattern { png "images/grey.png" interpolate 2 } 0.6 scale 1.3 } translate <2, -0.75, 0> }
