// Superellipsoids that are nearly boxes, cylinders and pillows: values on their faces are often exactly zero.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <1.5, 3.5, -7> look_at <0, -0.2, 0> angle 42 }
light_source { <5, 9, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.2 pigment { checker rgb <0.8, 0.8, 0.7>, rgb <0.3, 0.4, 0.3> } }
superellipsoid { <0.05, 0.05> rotate 20*y translate <-1.6, 0, -0.6> pigment { rgbf <0.9, 0.95, 1, 0.9> } finish { phong 0.5 } interior { ior 1.3 } }
superellipsoid { <1, 0.05> rotate <90, 0, 15> scale 0.8 translate <1.4, 0, -1> pigment { rgb <0.9, 0.5, 0.2> } }
superellipsoid { <0.03, 1> rotate 40*y translate <1.2, 0, 2> pigment { rgb <0.4, 0.7, 0.9> } finish { reflection 0.3 } }
superellipsoid { <0.1, 0.1> scale <0.7, 0.2, 0.7> translate <0, -0.8, -2.6> pigment { rgb <0.8, 0.2, 0.3> } }
