// no_reflection: seen by the camera, not in mirrors; on a part of a union and on a light as well.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

box { <-3, -1, 1.6>, <3, 2, 1.8> pigment { rgb 0.05 } finish { ambient 0 diffuse 0 reflection 0.9 } }

sphere { <-1.5, 0, 0>, 0.6 no_reflection pigment { rgb <0.9, 0.3, 0.2> } }
union { sphere { 0.5*y, 0.4 no_reflection } box { <-0.3, -1, -0.3>, <0.3, 0, 0.3> } pigment { rgb <0.9, 0.8, 0.2> } }
sphere { <1.5, 0, 0>, 0.6 no_image no_reflection pigment { rgb <0.4, 0.9, 0.3> } }
