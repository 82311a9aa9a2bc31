// The camera is behind a disc, outside of its box: it does not start inside of it.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2.3,3.1,-6.7> look_at 0 angle 35 right x*4/3 }
light_source { <4,6,-3> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
disc { 0, z, 1 pigment { rgbt <1,0.5,0.5,0.6> } interior { ior 1.5 fade_distance 1 fade_power 1 fade_color <0.2,0.5,0.8> } }
