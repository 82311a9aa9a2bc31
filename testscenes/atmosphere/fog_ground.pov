// Ground fog: altitude, offset, a tilted up, declared and changed, its sky.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 1.2, 0> angle 80 }
light_source { <20, 30, -20> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.4>] [0.6 rgb <0.2, 0.4, 0.9>] } } }
#declare Mist = fog { fog_type 2 distance 3 rgb <0.9, 0.9, 1> fog_alt 0.4 fog_offset 0.3 rotate 10*z }
fog { Mist }
fog { Mist distance 20 rgb <1, 0.5, 0.4> fog_alt 1 up <0.2, 1, 0> }
#declare I = -4;
#while (I < 5)
  cylinder { <I, 0, I*I/2>, <I, 3, I*I/2>, 0.3 pigment { rgb <0.6, 0.3, 0.2> } }
  #declare I = I + 1;
#end
sphere { <0, 1, -1.5>, 0.5 pigment { rgb 0.1 } finish { reflection 0.8 } }
plane { y, 0 pigment { checker rgb 0.3 rgb 0.6 } }
