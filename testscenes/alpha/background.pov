// What shows through: a background that is partly clear, layers, filters, maps of textures, in mirrors nothing.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgbft <0.2, 0.4, 0.6, 0.1, 0.5> }
camera { location <0, 1, -6> look_at 0 }
light_source { <5, 5, -9> rgb <1, 0.9, 0.7> }
sphere {
  <0.9, 0, 0>, 1
  pigment { gradient x color_map { [0 rgbt <0.9, 0.2, 0.1, 1>] [1 rgbt <0.1, 0.3, 1.2, 0>] } }
  finish { phong 0.7 }
}
box { <-3, -1.1, -1>, <3, -1, 3> pigment { checker rgb 1, rgbt <0.2, 0.2, 0.9, 0.6> } finish { reflection 0.3 } }
sphere { <2.4, 0.8, -1>, 0.5 pigment { rgbft <0.9, 0.5, 0.3, 0.2, 0.5> } finish { ambient 0.3 } }
sphere {
  <-0.3, 1.5, 0>, 0.5
  texture { pigment { rgb <1, 0, 0> transmit 0.5 } }
  texture { pigment { bozo color_map { [0 rgbt 1] [0.5 rgbft <0, 1, 0, 0.6, 0.2>] [1 rgb 1] } scale 0.4 } }
}
sphere {
  <-1.6, 0, 0>, 1
  texture {
    gradient y
    texture_map {
      [0.2 pigment { rgbf <1, 0.3, 0.2, 0.9> }]
      [0.8 pigment { rgbt <0, 0.3, 0.2, 0.4> } finish { reflection 0.6 }]
    }
    translate -1
    scale 2
  }
}
