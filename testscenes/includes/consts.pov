// consts.inc: constants of direction, angle and index of refraction.
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

#include "consts.inc"
Tile(pi) Tile(Water_Ior) Tile(Crown_Glass_Ior) Tile(Diamond_Ior) Tile(Flint_Glass_Ior)
Tiles(o) Tiles(xy) Tile(Plane_Map) Tile(Sphere_Map) Tile(Cylinder_Map) Tile(Torus_Map) Tile(Bi) Tile(Norm) Tile(e)
Tile(FoV_45) Tile(Ruby_Ior) Tiles(xz)
