// Unions that a loop and a macro put into one another, far deeper than anyone writes: as they are, cut, and cut out of a box.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -9*z look_at 0 }
light_source { <4, 6, -9> rgb 1 }

#declare A = sphere { 0, 0.1 }
#for (I, 1, 1100)
  #declare A = union { object { A } sphere { <sin(I) * 2, cos(I * 1.3) * 1.5, 0>, 0.05 } }
#end
object { A pigment { rgb x } translate <-2.2, 1.6, 0> }
object { A clipped_by { plane { y, 0.2 } } pigment { rgb y } translate <2.2, 1.6, 0> }
difference {
  box { <-2.1, -1.6, 0>, <2.1, 1.6, 0.3> }
  object { A }
  pigment { rgb z + 0.3 }
  translate <-2.2, -1.8, 0>
}

#declare B = box { -0.1, 0.1 }
#macro Grow(N)
  #local K = N;
  #while (K > N - 400)
    #declare B = union { object { B } box { -0.1, 0.1 translate <cos(K), sin(K), 0> * K / 800 } translate 0.0005*x }
    #local K = K - 1;
  #end
  #if (N > 400) Grow(N - 400) #end
#end
Grow(1200)
object { B pigment { rgb <1, 1, 0> } translate <2, -1.8, 0> }
