// What lies beyond the flat box of a disc is seen only by rays that pass the box.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2,3,-6> look_at 0 angle 45 right x*4/3 }
light_source { <4,6,-3> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
intersection { disc { 0, <1,3,-1>, 1 } box { -0.6, 2 } pigment { rgb z } }
