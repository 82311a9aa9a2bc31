// How long scenes take to be read: 200,000 spheres in a loop. See docs/performance.md.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z }
#declare R = seed(1);
#for (I, 1, 200000)
  sphere { <rand(R), rand(R), rand(R)> * 100, 0.2 pigment { color rgb <rand(R), 0.5, 1> } }
#end
