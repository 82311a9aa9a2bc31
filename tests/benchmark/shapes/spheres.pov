// How fast many of a kind are traced, see docs/performance.md. 100,000 spheres of two sizes, scattered in a ball.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 angle 50 }
light_source { <4, 6, -8> rgb 1 }
#declare R = seed(11);
#for (I, 1, 100000)
  #declare P = vnormalize(<rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>) * pow(rand(R), 1 / 3);
  sphere { P, 0.004 + 0.008 * mod(I, 2) pigment { rgb <0.5 + 0.5 * P.x, 0.5 + 0.5 * P.y, 0.8> } finish { phong 0.3 } }
#end
