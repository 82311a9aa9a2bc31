// Landscapes of functions: flat and smooth, under water, moved, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, 0.1, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

#declare Hills = function { 0.5 + 0.25 * sin(x * 9) * cos(y * 7) + 0.2 * sin(x * 23 + y * 11) }
height_field { function 24, 18 { Hills(x, y, z) } pigment { rgb <1, 0.8, 0.3> } translate <-0.5, -0.5, -0.5> scale <2.6, 1.2, 2.6> rotate -20 * x translate <-3.1, 0, 0.6> }
height_field { function 40, 40 { Hills(x, y, z) } smooth pigment { rgb <0.4, 0.7, 0.9> } finish { phong 0.4 } translate <-0.5, -0.5, -0.5> scale <2.6, 1.2, 2.6> rotate <-20, 0, 0> translate <0, 0, 0.6> }
height_field { function 30, 30 { Hills(x, y, z) } water_level 0.45 smooth pigment { gradient y color_map { [0.4 rgb <0.1, 0.5, 0.2>] [1 rgb 1] } } translate <-0.5, -0.5, -0.5> scale <2.6, 1.2, 2.6> rotate <-30, 20, 0> translate <3.1, 0, 0.6> }
difference {
  box { -0.8, 0.8 }
  height_field { function 20, 20 { Hills(x, y, z) } translate <-0.5, -0.2, -0.5> scale <1.8, 1, 1.8> inverse }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate 30 * y
  translate <-1.6, -0.4, -2.2>
}
intersection {
  height_field { function 60, 30 { pattern { bozo scale 0.12 } } hierarchy off translate <-0.5, 0, -0.5> scale <2, 0.8, 2> }
  cylinder { -y, y, 0.9 }
  pigment { rgb <0.6, 0.5, 0.9> }
  rotate <-15, 10, 0>
  translate <1.4, -0.8, -2>
}
