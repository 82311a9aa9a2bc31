// checker: default colours, given colours, scaled, and on faces that lie exactly in the planes of the pattern.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { <-1.5, 0, 0>, 0.8 pigment { checker scale 0.25 } }
box { <-0.4, -0.9, -0.5>, <0.6, 0.7, 0.5> rotate 25*y pigment { checker rgb <0.9, 0.6, 0.2>, color rgb <0.3, 0.1, 0.1> scale 0.35 } }
cylinder { <1.6, -0.9, 0>, <1.6, 0.9, 0>, 0.6 pigment { checker rgb <0.2, 0.5, 0.9> rgb <0.9, 0.9, 0.5> rotate 45*y scale <0.2, 0.5, 0.2> } }
box { <-0.4, -0.95, -2.2>, <1.2, -0.8, -1.5> pigment { checker rgb <0.9, 0.2, 0.2>, rgbt <0.9, 0.9, 0.9, 0.5> scale <0.2, 0.1, 0.2> translate 0.1 } }
