// How long scenes take to be read: a recursive macro, 57,313 calls. See docs/performance.md.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z }
#macro Fib(N)
  #if (N < 2)
    #local R = N;
  #else
    #local R = Fib(N - 1) + Fib(N - 2);
  #end
  R
#end
#declare F = Fib(22);
sphere { 0, F }
