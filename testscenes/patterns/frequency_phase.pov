// frequency and phase: more repeats, shifted, negative, with each wave.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.1 }
camera { location -10*z look_at 0 right x*4/3 angle 38 }

#declare Map = color_map { [0 rgb <0.1, 0.3, 0.1>] [0.5 rgb <0.9, 0.8, 0.2>] [1 rgb <0.9, 0.2, 0.3>] }
#macro Panel(Row, Pigment)
  box { <-2.9, -0.25, 0>, <2.9, 0.25, 0.1> pigment { Pigment } finish { ambient 1 diffuse 0 } translate (1.86 - 0.6*Row)*y }
#end
Panel(0, pigment { gradient x color_map { Map } frequency 2 })
Panel(1, pigment { gradient x color_map { Map } phase 0.25 })
Panel(2, pigment { gradient x color_map { Map } frequency -1.5 })
Panel(3, pigment { gradient x color_map { Map } frequency 0.5 phase -0.3 triangle_wave })
Panel(4, pigment { gradient x color_map { Map } frequency 3 phase 0.6 sine_wave })
Panel(5, pigment { gradient x color_map { Map } frequency 0 phase 0.4 })
Panel(6, pigment { gradient x color_map { Map } phase 2.7 scallop_wave })
