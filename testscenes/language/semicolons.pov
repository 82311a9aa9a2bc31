// Where a semicolon must stand after #declare and where it may: after numbers, vectors, objects, in a row, at the end of the file.
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

#declare A = 0.1; #declare B = A + 0.1; Tile(A) Tile(B)
#declare V = <0.1, 0.2, 0.3>; Tiles(V)
#declare O = sphere { 0, 0.3 }
#declare P = sphere { 0, 0.3 };
#declare F = finish { ambient 1 };
object { O pigment { rgb <0.9, 0.2, 0.2> } finish { F } translate <-1, -1, 0> }
object { P pigment { rgb <0.2, 0.9, 0.2> } finish { F } translate <0, -1, 0> }
#declare T = array[2] { 0.3, 0.6 };
#declare T[1] = 0.65; Tile(T[1])
#macro M(A) #local B = A; B #end Tile(M(0.75))
#declare Last = 0.85;
