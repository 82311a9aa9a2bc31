// Lines of letters: fonts, kerning, offsets, thickness, cut, both sides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -10> look_at <0, 0.4, 0> angle 42 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.6 pigment { checker rgb 0.8 rgb 0.6 } }

text { ttf "timrom.ttf" "AVATAR gjQ&8" 0.4, 0 pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } scale 0.8 translate <-3.6, 2, 0> }
text { ttf "cyrvetic.ttf" "Turned ring" 1, 0.1 * x pigment { rgb <0.4, 0.7, 0.9> } scale 0.8 rotate <20, 30, 0> translate <-3.4, 0.7, 0> }
text { internal 3 "crystal" 0.2, <0, 0.05, 0> pigment { rgb <0.8, 0.3, 0.3> } interior_texture { pigment { rgb y } } rotate -10 * z translate <0.6, 0.9, -0.5> }
text { internal 0 "Pa" 0.3, 0 pigment { rgb <0.3, 0.7, 0.3> } scale 1.2 translate <-3.6, -1, -1> }
difference {
  box { <0, -0.2, 0>, <3.4, 0.9, 0.5> }
  text { ttf "timrom" "cut out" 0.6, 0 translate <0.3, 0.1, -0.2> }
  pigment { rgb <0.6, 0.5, 0.9> }
  rotate -10 * y
  translate <-0.4, -1.2, -1>
}
