// Bows over each other: arc, falloff, distance, filter and transmit, before surfaces, in mirrors, behind fog.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -8> look_at <0, 3, 0> angle 90 }
light_source { <20, 30, -60> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
fog { distance 200 rgb 0.6 }
#declare Colors = color_map {
  [0.00 rgbft <0.5, 0.2, 0.8, 0.2, 0.9>] [0.25 rgbft <0.2, 0.3, 1, 0.1, 0.6>] [0.5 rgbft <0.2, 1, 0.3, 0.4, 0.5>]
  [0.75 rgbft <1, 1, 0.2, 0, 0.3>] [1 rgbft <1, 0.1, 0.1, 0.1, 0.9>]
}
rainbow { angle 30 width 8 distance 10 direction <0, -0.1, 1> color_map { Colors } arc_angle 150 falloff_angle 60 }
rainbow { angle 38 width 14 distance 30 direction <0, -0.1, 1> up <0.3, 1, 0> color_map { Colors } }
plane { y, 0 pigment { checker rgb 0.3 rgb 0.6 } finish { reflection 0.3 } }
box { <-3, 0, 2>, <-1, 9, 4> pigment { rgb <0.7, 0.4, 0.3> } }
