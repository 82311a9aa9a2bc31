// Superellipsoids from boxes over balls to stars, moved, cut and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -11> look_at <0, 0.2, 0> angle 46 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

superellipsoid { <0.25, 0.25> pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } rotate <20, 30, 0> translate <-3.8, 0.1, 0.4> }
superellipsoid { <1, 1> pigment { rgb <0.4, 0.7, 0.9> } scale <0.7, 1, 0.7> translate <-1.5, 0, 0.4> }
superellipsoid { <1, 0.1> pigment { rgb <0.8, 0.3, 0.3> } rotate <60, 20, 0> scale 0.8 translate <0.7, 0.1, 0.4> }
superellipsoid { <3, 1> pigment { rgb <0.3, 0.7, 0.3> } rotate <30, 50, 0> translate <3.2, 0.1, 0> }
superellipsoid { <2, 3> pigment { rgbf <1, 0.7, 1, 0.6> } rotate <20, 10, 30> translate <-3.2, -0.3, -2.9> }
difference {
  superellipsoid { <0.2, 0.5> }
  superellipsoid { <1, 0.3> scale <0.6, 0.6, 2> }
  pigment { rgb <0.6, 0.5, 0.9> }
  scale 0.8 rotate <0, 40, 0>
  translate <-0.4, -0.4, -2.8>
}
intersection {
  box { -0.9, 0.9 }
  superellipsoid { <0.6, 1.7> inverse }
  pigment { rgb <0.9, 0.6, 0.3> }
  rotate <10, 25, 0>
  translate <2.4, -0.3, -2.8>
}
