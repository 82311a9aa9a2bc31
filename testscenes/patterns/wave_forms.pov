// The wave types over the same gradient: ramp, triangle, sine, scallop, cubic and poly.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.1 }
camera { location -10*z look_at 0 right x*4/3 angle 38 }

#declare Map = color_map { [0 rgb <0.1, 0.1, 0.3>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.9>] }
#macro Panel(Row, Pigment)
  box { <-2.9, -0.25, 0>, <2.9, 0.25, 0.1> pigment { Pigment } finish { ambient 1 diffuse 0 } translate (1.86 - 0.6*Row)*y }
#end
Panel(0, pigment { gradient x color_map { Map } ramp_wave })
Panel(1, pigment { gradient x color_map { Map } triangle_wave })
Panel(2, pigment { gradient x color_map { Map } sine_wave })
Panel(3, pigment { gradient x color_map { Map } scallop_wave })
Panel(4, pigment { gradient x color_map { Map } cubic_wave })
Panel(5, pigment { gradient x color_map { Map } poly_wave 3 })
Panel(6, pigment { gradient x color_map { Map } poly_wave 0.4 })
