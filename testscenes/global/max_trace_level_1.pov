// max_trace_level 1: no reflection is followed.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
background { rgb <0.3, 0.45, 0.7> }
box { <-3, -1, 3>, <3, 3, 3.2> rotate 5*y pigment { rgb 0.02 } finish { ambient 0 diffuse 0 reflection 0.85 } }
box { <-3, -1, -7.2>, <3, 3, -7> rotate 5*y pigment { rgb 0.02 } finish { ambient 0 diffuse 0 reflection 0.85 } }
sphere { <-1.2, 0, 0>, 0.9 pigment { rgb <0.9, 0.5, 0.2> } finish { reflection 0.3 } }
sphere { <1, -0.2, -1>, 0.7 pigment { rgbt 0.9 } finish { diffuse 0.1 } interior { ior 1.4 } }
