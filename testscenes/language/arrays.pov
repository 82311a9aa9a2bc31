// Arrays: of numbers, of vectors, of two dimensions, of objects, textures and strings; initialised, sized and changed.
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

#declare A = array[5] { 0.1, 0.3, 0.5, 0.7, 0.9 };
#declare B = array[2][3] { { 0.1, 0.2, 0.3 }, { 0.4, 0.5, 0.6 } };
#declare C = array[4];
#for (I, 0, 3) #declare C[I] = <I, I*I, 1>*0.11; #end
#declare Names = array[3] { "one", "three", "five" };
#declare Trailing = array[2] { 0.25, 0.75, }
#for (I, 0, dimension_size(A, 1) - 1) Tile(A[I]) #end
#for (I, 0, dimension_size(B, 1) - 1) #for (J, 0, dimension_size(B, 2) - 1) Tile(B[I][J]) #end #end
Tile(dimensions(A)*0.3) Tile(dimensions(B)*0.3)
#for (I, 0, 3) Tiles(C[I]) #end
#for (I, 0, 2) Tile(strlen(Names[I])/7) #end
#declare A[2] = A[1] + A[3];
Tile(A[2]) Tile(A[int(3.9)]) Tile(Trailing[1]) Tile(defined(A)*0.3)
#declare D = A;
#declare D[0] = 0.65;
Tile(D[0]) Tile(A[0])
#macro Last(List) List[dimension_size(List, 1) - 1] #end
Tile(Last(A)) Tile(Last(array[3] { 0.2, 0.4, 0.8 })) Tile(C[2].y)
#macro Set(List, Index, Value) #declare List[Index] = Value; #end
Set(A, 4, 0.15)
Tile(A[4])
#declare Shapes = array[3] { sphere { 0, 0.2 }, box { -0.18, 0.18 }, cylinder { -0.2*y, 0.2*y, 0.15 } };
#declare Paints = array[2] { pigment { rgb <0.9, 0.3, 0.2> }, pigment { gradient y scale 0.1 } };
#for (I, 0, 2) object { Shapes[I] pigment { Paints[mod(I, 2)] } translate <-2 + 0.6*I, -1.2, 0> } #end
