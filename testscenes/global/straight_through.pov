// A ray that goes straight on does not count as a level: twelve panes and max_trace_level 3.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
background { rgb <0.3, 0.45, 0.7> }
#for (I, 0, 11)
  box { <-2 + 0.15*I, -0.95, -1 + 0.2*I>, <1 + 0.15*I, 1, -0.95 + 0.2*I> pigment { rgbt <0.6 + 0.03*I, 0.9, 1 - 0.05*I, 0.85> } }
#end
sphere { <0.5, 0, 2>, 0.8 pigment { rgb <0.9, 0.2, 0.1> } }
