// What shows through a sky of several layers, and a rainbow in front of it.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgbt <0.9, 0.8, 0.1, 0.7> }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.3, 0.5, 0.9>] [0.5 rgbt <1, 1, 1, 1>] } }
  pigment { bozo color_map { [0.4 rgbt 1] [0.9 rgbft <0.9, 0.5, 0.5, 0.3, 0.2>] } scale 0.2 }
  emission 0.9
}
rainbow { angle 30 width 12 distance 20 direction <0, 0, 1>
  color_map { [0 rgbt <1, 0, 0, 0.5>] [1 rgbt <0, 0, 1, 0.9>] } }
camera { location <0, 1, -6> look_at <0, 1.6, 0> }
light_source { <5, 5, -9> rgb 1 }
sphere { <-1, 1, 0>, 1 pigment { rgbf <0.9, 0.5, 0.3, 0.6> } finish { reflection 0.4 } }
sphere { <1.4, 1, 0>, 1 pigment { rgb <0.2, 0.5, 0.3> } finish { reflection 0.4 } }
