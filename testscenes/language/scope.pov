// #declare, #local and #undef: names in macros and in included files, names hidden and found again.
// compare: share 99.9
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.05 }
camera { location -10*z look_at 0 right x*4/3 angle 36 }
#default { finish { ambient 1 diffuse 0 } }

// A tile tells its number by its colour: red the number itself, green a third of it, blue a thirtieth, each modulo 1.
#declare Tile_Count = 0;
#macro Fraction(A) (A - floor(A)) #end
#macro Tile(Value)
  box {
    <-0.27, -0.21, 0>, <0.27, 0.21, 0.1>
    translate <-2.7 + 0.6*mod(Tile_Count, 10), 1.92 - 0.48*int(Tile_Count/10), 0>
    pigment { rgb <Fraction(Value), Fraction(Value/3), Fraction(Value/30)> }
  }
  #declare Tile_Count = Tile_Count + 1;
#end
#macro Tiles(Vector) Tile(Vector.x) Tile(Vector.y) Tile(Vector.z) #end

#declare A = 0.1;
#local B = 0.2;
Tile(A) Tile(B)
#macro Inside() Tile(A) #local A = 0.3; Tile(A) #declare C = A + 0.1; #local D = 0.9; #end
Inside() Tile(A) Tile(C) Tile(defined(D)*0.5 + 0.05)
#macro Outer() #local E = 0.6; Inner() Tile(E) #end
#macro Inner() Tile(E) #declare E = 0.7; #end
#declare E = 0.55;
Outer() Tile(E)
#include "scope.inc"
Tile(From_File) Tile(defined(Hidden_In_File)*0.5 + 0.05)
#undef A
Tile(defined(A)*0.5 + 0.15)
#declare A = 0.85;
Tile(A)
#declare a = 0.95;
Tile(A) Tile(a)
