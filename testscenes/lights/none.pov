// No light at all: only ambient and emission show.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.1, 0.15, 0.25> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { <-1.2, 0, 0>, 0.9 pigment { rgb <0.9, 0.5, 0.2> } finish { ambient 0.4 } }
sphere { <1.2, 0, 0>, 0.9 pigment { rgb <0.3, 0.5, 0.9> } finish { emission 0.7 ambient 0 } }
