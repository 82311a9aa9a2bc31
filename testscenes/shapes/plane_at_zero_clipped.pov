// Planes at 0 that are clipped: round pieces without holes.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2.3,3.1,-6.7> look_at 0 angle 35 right x*4/3 }
light_source { <4,6,-3> rgb 1 }
plane { y, 0 clipped_by { sphere { 0, 1 } } pigment { rgb x } }
plane { z, 0 clipped_by { cylinder { -z, z, 0.6 } } pigment { rgb z } }
