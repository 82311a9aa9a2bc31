// math.inc: statistics, interpolation and vectors.
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

#include "math.inc"
#declare List = array[5] { 0.1, 0.9, 0.4, 0.7, 0.3 };
Tile(Mean(List)) Tile(Std_Dev(List, Mean(List)))
Tile(Interpolate(0.3, 0, 1, 0.2, 0.8, 1)) Tile(Interpolate(0.3, 0, 1, 0.2, 0.8, 2.5))
Tile(VDist(<1, 2, 3>, <2, 0, 1>)) Tile(VAngle(x, <1, 1, 0>)) Tile(VAngleD(x, <1, 1, 0>)/7) Tile(VCos_Angle(x + y, y + z))
Tiles(VPerp_To_Vector(<0.3, 0.5, 0.1>)) Tiles(VPerp_To_Plane(x, y + 0.2*z)) Tiles(VPerp_Adjust(x + y, y))
Tiles(VProject_Plane(<0.1, 0.5, 0.9>, y)) Tiles(VProject_Axis(<0.1, 0.5, 0.9>, x + y)) Tile(VRotation(x, x + y, z)) Tile(VRotationD(x, x + y, z)/70)
Tiles(VPow(<0.3, 0.5, 0.7>, 1.5)) Tiles(VSqr(<0.3, 0.5, 0.7>)) Tiles(VWith_Len(<1, 2, 3>, 0.9))
Tile(VZero(<0, 0, 0>)) Tile(VEq(x, x)*0.3)
