// Half a ball: its cut face, at y = 0, is even.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2.3,3.1,-6.7> look_at 0 angle 35 right x*4/3 }
light_source { <4,6,-3> rgb 1 }
difference { sphere { 0, 1 } plane { -y, 0 } pigment { rgb z } }
