// The exponent of a reflection is of negative light too: raised to an even power it is positive.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2,3,-6> look_at 0 angle 45 right x*4/3 }
light_source { <4,6,-3> rgb 1 }
background { rgb <-0.3,0.4,0.9> }
sphere { 0, 0.9 pigment { rgb <0.1,0.7,0.2> } finish { reflection { 0.5 exponent 0.5 } } }
