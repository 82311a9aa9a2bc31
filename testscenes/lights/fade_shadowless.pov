// A light that fades and casts no shadow, and fade_distance without fade_power, which does nothing.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.1, 0.15, 0.25> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

light_source { <-1.5, 1.8, -1.5>, rgb 1 fade_distance 2 fade_power 2 shadowless }
light_source { <3, 5, -4>, rgb 0.4 fade_distance 2 }

sphere { <-1.2, 0, 0>, 0.9 pigment { rgb 0.9 } finish { phong 0.6 } }
box { <0.6, -1, -0.5>, <1.6, 0.4, 0.5> rotate 20*y pigment { rgb <0.8, 0.8, 0.7> } finish { specular 0.4 } }
