// A floor at y = 0 with a hole, and no others.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2.3,3.1,-6.7> look_at 0 angle 35 right x*4/3 }
light_source { <4,6,-3> rgb 1 }
difference { plane { y, 0 } cylinder { -y, y, 0.5 } pigment { checker rgb x rgb 1 } }
plane { y, -1 pigment { rgb y } }
