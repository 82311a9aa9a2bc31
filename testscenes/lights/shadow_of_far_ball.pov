// Most shapes are not met beyond 1e7: a ball that is farther away casts no shadow.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,4,-6> look_at 0 angle 40 right x*4/3 }
light_source { <0,5e7,0> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
sphere { <0,2e7,0>, 5e6 pigment { rgb 1 } }
sphere { 0, 1 pigment { rgb x } }
