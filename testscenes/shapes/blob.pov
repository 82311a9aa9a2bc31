// Blobs of balls and cylinders: strengths above and below 0, textures of their parts, moved parts, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.3, 0> angle 50 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1 pigment { checker rgb 0.8 rgb 0.6 } }

#declare Red = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.6 } }
#declare Dots = texture { pigment { spotted color_map { [0.4 rgb 1] [0.4 rgb <0.1, 0.3, 0.8>] } scale 0.2 } }

#declare Three = blob {
  threshold 0.65
  sphere { <0.75, 0, 0>, 1, 1 }
  sphere { <-0.375, 0.64952, 0>, 1, 1 }
  component 1, 1, <-0.375, -0.64952, 0>
}
object { Three pigment { rgb <1, 0.8, 0.3> } finish { specular 0.5 } translate <-3.4, 0.3, 0> }
object { Three texture { Red } scale <0.6, 1, 1.3> rotate <10, 40, 20> translate <-1.2, 0.3, 0.6> }
blob {
  threshold 0.4
  cylinder { <-1, 0, 0>, <1, 0, 0>, 0.6, 1 texture { Red } }
  cylinder { 0, <0, 1.2, 0>, 0.5, strength 1 rotate 30 * z texture { Dots } }
  sphere { 0, 0.9, strength 1.2 texture { Dots } scale <0.5, 1.3, 0.6> translate <0.9, 0.4, 0> }
  sphere { <-0.8, 0.2, -0.4>, 0.7, -1.5 }
  pigment { rgb <0.3, 0.7, 0.3> }
  rotate -20 * y
  translate <1.2, 0, 0>
}
difference {
  object { Three }
  box { <0, -2, -2>, <2, 2, 0> }
  pigment { rgb <0.4, 0.5, 0.9> }
  translate <3.6, 0.3, 0.2>
}
difference {
  box { -0.7, 0.7 }
  blob { threshold 0.3 sphere { 0, 1, 1 } cylinder { -z, z, 0.4, 1 } cylinder { -y, y, 0.4, 1 } }
  pigment { rgb <0.9, 0.6, 0.8> }
  rotate 30 * y
  translate <-2.6, -0.3, -2.4>
}
// Many parts, each a little of the whole; one that shines through.
blob {
  threshold 0.5
  #for (I, 0, 30)
    sphere { <cos(I * 0.7) * (0.2 + I / 40), sin(I * 0.7) * (0.2 + I / 40), sin(I * 1.3) * 0.2>, 0.3, 0.9 }
  #end
  sturm
  pigment { rgbf <0.6, 1, 0.7, 0.6> }
  interior { ior 1.2 }
  translate <-0.2, -0.1, -2.6>
}
intersection {
  blob { threshold -0.2 sphere { <0.5, 0, 0>, 0.8, -1 } sphere { <-0.5, 0, 0>, 0.8, -1 } hierarchy off inverse }
  sphere { 0, 1.2 }
  pigment { rgb <0.6, 0.9, 0.9> }
  translate <2.4, -0.2, -2.2>
}
