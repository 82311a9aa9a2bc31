// Two rainbows and a halo: arcs that fade, tilted, with gaps, behind and before things.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -10> look_at <0, 4, 10> right x*4/3 angle 80 }
light_source { <-10, 20, -50> rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
#declare Colours = color_map { [0 rgbt <1, 0.4, 0.9, 1>] [0.2 rgbt <0.6, 0.3, 0.9, 0.6>] [0.5 rgbt <0.2, 0.9, 0.3, 0.5>] [0.8 rgbt <1, 0.3, 0.2, 0.5>] [1 rgbt <1, 0.3, 0.2, 1>] }
rainbow { direction <0, -0.2, 1> angle 32 width 6 distance 30 color_map { Colours } arc_angle 150 falloff_angle 60 up <0.2, 1, 0> }
rainbow { direction <0.1, 0.3, 1> angle 18 width 4 distance 15 color_map { Colours } }
rainbow { direction <-0.2, 0.1, 1> angle 45 width 9 distance 60 jitter 0 color_map { Colours } arc_angle 90 falloff_angle 90 }
plane { y, -1 pigment { checker rgb <0.3, 0.5, 0.2>, rgb <0.4, 0.6, 0.3> scale 4 } }
sphere { <-3, 3, 2>, 2 pigment { rgb <0.9, 0.8, 0.3> } }
sphere { <6, 6, 30>, 5 pigment { rgb <0.9, 0.3, 0.3> } }
