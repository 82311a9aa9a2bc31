// Maps and lists of pigments, within each other, with turbulence; average.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker pigment { rgb <0.9, 0.85, 0.7> } pigment { bozo scale 0.2 } } }
sphere { <-1.4, 0, 0>, 0.9 pigment { gradient y turbulence 0.2 pigment_map { [0.2 rgb <0.8, 0.2, 0.1>][0.5 checker rgb 0, rgb 1 scale 0.2][0.8 granite scale 0.3] } } }
sphere { <0.4, 0, 0.4>, 0.8 pigment { average pigment_map { [1 gradient x color_map { [0 rgb 0][1 rgb x] } scale 0.5][2 wood scale 0.1][0.5 rgbt <0, 1, 0, 0.6>] } } }
box { <1.3, -1, -0.6>, <2.2, 0.6, 0.6> pigment { brick pigment { rgb 0.8 } pigment { radial pigment_map { [0 rgb <0.7, 0.2, 0.2>][1 bozo scale 0.05] } frequency 6 } scale 0.08 } }
