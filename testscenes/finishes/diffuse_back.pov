// What shines through from behind: the second number of diffuse, on sheets and glass, with lights on both sides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 right x*4/3 angle 45 }
light_source { <-4, 3, 6> rgb <1, 0.8, 0.6> }
light_source { <5, 4, -6> rgb 0.5 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.3 } }
#macro Sheet(X, Finish) polygon { 4, <-0.45, -0.8>, <0.45, -0.8>, <0.45, 0.8>, <-0.45, 0.8> pigment { rgbt <0.5, 0.8, 0.3, 0.1*(X + 3)> } finish { Finish } rotate 20*y translate X*x } #end
Sheet(-2.2, finish { diffuse 0.3, 0.7 })
Sheet(-1.1, finish { diffuse albedo 0.4, 0.5 ambient 0.1 })
Sheet(0, finish { diffuse 0, 0.9 brilliance 2 })
Sheet(1.1, finish { diffuse 0.5, 0.5 specular 0.6 phong 0.4 })
Sheet(2.2, finish { diffuse 0.7 })
sphere { <-1.4, -0.5, -1.8>, 0.45 pigment { rgb <0.9, 0.3, 0.3> } finish { diffuse 0.4, 0.6 } normal { bumps 0.7 scale 0.1 } }
sphere { <0, -0.5, -1.8>, 0.45 pigment { rgb <0.3, 0.3, 0.9> } finish { diffuse 0.4, 0.6 brilliance 0.5 specular albedo 0.5 phong albedo 0.2 } }
difference { sphere { <1.4, -0.5, -1.8>, 0.45 } plane { z, -1.9 } pigment { rgb <0.3, 0.9, 0.4> } finish { diffuse 0.2, 0.8 } double_illuminate }
