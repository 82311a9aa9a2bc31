// All that a level of quality leaves out. Rendered at each level by a test.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.5, -7> look_at <0, 0.5, 0> }
background { rgb <0.1, 0.2, 0.3> }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } quick_color rgb <0.5, 0.3, 0.3> }
}
fog { distance 60 rgb <0.6, 0.6, 0.7> }
rainbow {
  angle 30 width 12 distance 20 direction <0, 0, 1>
  color_map { [0 rgbt <1, 0, 0, 0.5>] [1 rgbt <0, 0, 1, 0.9>] } }
light_source { <-4, 6, -5> rgb 0.7 area_light <2, 0, 0>, <0, 0, 2>, 4, 4 adaptive 0 area_illumination on }
light_source {
  <3, 5, -3> rgb <0.5, 0.5, 0.2> spotlight point_at <1, 0, 0> radius 12 falloff 20
  projected_through { sphere { <2, 2.5, -1.5>, 0.5 } }
}
light_source { <0, 8, 3> rgb 0.1 shadowless }
plane { y, 0 pigment { checker rgb 1, rgb <0.6, 0.3, 0.2> quick_color rgb <0.2, 0.6, 0.3> } finish { reflection 0.2 } }
sphere {
  <-2.2, 1, 0>, 1
  pigment { bozo color_map { [0 rgb <1, 0.2, 0.1>] [1 rgbf <0.2, 0.9, 0.3, 0.9>] } scale 0.4
            quick_color rgbf <0.9, 0.8, 0.2, 0.5> }
  normal { bumps 0.7 scale 0.2 }
  finish { phong 0.8 }
}
sphere {
  <0, 1, 0>, 1
  pigment { rgbf <0.9, 0.9, 1, 0.8> }
  interior { ior 1.5 fade_distance 2 fade_power 1 }
  finish { specular 0.6 reflection 0.1 }
}
sphere {
  <2.2, 1, 0>, 1
  texture { pigment { rgb <0.3, 0.3, 0.7> } finish { reflection { 0.2, 0.9 fresnel off } conserve_energy } }
  texture { pigment { gradient y color_map { [0 rgbt 1] [0.5 rgbt <1, 1, 0, 0.6>] [1 rgb <0, 1, 1>] }
                      quick_color rgbt <0.4, 0.9, 0.9, 0.4> }
            finish { reflection 0.3 conserve_energy } }
}
box {
  <-1, 0, -2.4>, <-0.2, 0.7, -1.8>
  pigment { gradient x pigment_map { [0 rgb x quick_color rgb y] [1 rgb <0, 0, 1>] } }
}
