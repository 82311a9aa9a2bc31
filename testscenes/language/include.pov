// #include: a file of objects, one in a folder below, one twice, one inside a block, one that includes another.
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

#include "parts/numbers.inc"
#declare Paint = concat("parts/", "paint.inc");
sphere { <-1, -1, 0>, 0.4 #include "parts/paint.inc" }
sphere { <0, -1, 0>, 0.4 #include Paint scale 1 }
#for (I, 0, 2)
  #declare Place = I;
  #include "parts/ball.inc"
#end
Tile(Of_Numbers)
