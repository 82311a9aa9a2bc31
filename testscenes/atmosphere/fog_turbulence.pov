// Turbulence of constant and of ground fog, with its octaves, omega, lambda and depth.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 1.2, 0> angle 80 }
light_source { <20, 30, -20> rgb 1 }
background { rgb <0.2, 0.4, 0.9> }
fog { distance 25 rgb <0.9, 0.8, 0.7> turbulence <0.4, 0.2, 0.4> turb_depth 0.9 octaves 3 lambda 2.5 omega 0.6 }
fog { fog_type 2 distance 4 rgb 0.9 fog_alt 0.6 turbulence 0.3 }
#declare I = -4;
#while (I < 5)
  cylinder { <I, 0, I*I/2>, <I, 3, I*I/2>, 0.3 pigment { rgb <0.6, 0.3, 0.2> } }
  #declare I = I + 1;
#end
plane { y, 0 pigment { checker rgb 0.3 rgb 0.6 } }
plane { z, 30 pigment { rgb <0.3, 0.6, 0.3> } }
