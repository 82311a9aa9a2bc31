// gradient with color_map: along an axis, along a slanted vector, with a jump in the map, with the older entries of two values.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.1 }
camera { location -10*z look_at 0 right x*4/3 angle 38 }
light_source { -100*z, rgb 1 }

#macro Panel(Row, Pigment)
  box { <-2.9, -0.3, 0>, <2.9, 0.3, 0.1> pigment { Pigment } finish { ambient 1 diffuse 0 } translate (1.8 - 0.72*Row)*y }
#end
Panel(0, pigment { gradient x })
Panel(1, pigment { gradient x color_map { [0 rgb <1, 0, 0>] [0.3 rgb <1, 1, 0>] [1 rgb <0, 0, 1>] } scale 2 })
Panel(2, pigment { gradient <1, 1, 0> color_map { [0.2 rgb 0] [0.2 rgb <0.9, 0.4, 0.2>] [0.8 rgb <0.3, 0.8, 0.9>] } scale 0.7 })
Panel(3, pigment { gradient -x*5 color_map { [0.0 0.4 color rgb 0.1 color rgb 0.9] [0.4 1.0 color rgb <0, 0.5, 1> color rgb <1, 0.5, 0>] } })
Panel(4, pigment { gradient y color_map { [0 rgb <0.9, 0.2, 0.5>] [0.5 rgb <0.2, 0.9, 0.5>] [1 rgb <0.2, 0.2, 0.9>] } scale 0.6 translate -0.3*y })
Panel(5, pigment { gradient x color_map { [0.25 rgbt <1, 0, 0, 0>] [0.75 rgbt <0, 1, 0, 1>] } translate 0.3*x })
