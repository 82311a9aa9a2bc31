// A liquid that touches its glass, a label upon it, and the same seen in a mirror: rays that go on after a reflection or
// a refraction ask in their own order.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
#default { finish { ambient 0.2 diffuse 0.7 } }
camera { location <1.5, 3.5, -8> look_at <0, 1, 0> angle 35 right x*4/3 }
light_source { <-6, 10, -8>, 1 }
background { rgb <0.5, 0.7, 0.9> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.4, 0.3, 0.2> } }
plane { -z, -3 pigment { rgb 0.1 } finish { reflection 0.8 } }
difference {
  cylinder { 0, 3*y, 1.2 }
  cylinder { 0.2*y, 3.1*y, 1 }
  pigment { rgbf <0.95, 1, 0.95, 0.9> }
  interior { ior 1.5 }
}
cylinder { 0.2*y, 2*y, 1 pigment { rgbf <0.9, 0.3, 0.2, 0.7> } interior { ior 1.33 } }
box { <2, 0, -1>, <3.5, 1.5, 0.5> pigment { rgb <0.2, 0.4, 0.8> } }
disc { <2.75, 0.75, -1>, z, 0.5 pigment { rgb <1, 0.8, 0.1> } }
box { <2.2, 1.5, -0.8>, <3.3, 2.3, 0.3> pigment { rgb <0.3, 0.7, 0.3> } }
