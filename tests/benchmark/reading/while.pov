// How long scenes take to be read: 1,000,000 turns of #while. See docs/performance.md.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z }
#declare I = 0;
#declare S = 0;
#while (I < 1000000)
  #declare S = S + sin(I) * 2;
  #declare I = I + 1;
#end
sphere { 0, 1 }
