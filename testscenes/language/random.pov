// rand and seed: the sequences of several seeds, drawn in turn, as coloured tiles.
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

#declare First = seed(1);
#declare Second = seed(12345);
#declare Third = seed(-7);
#declare Fourth = seed(2.7);
#for (I, 1, 12) Tile(rand(First)) #end
#for (I, 1, 12) Tile(rand(Second)*10) #end
#for (I, 1, 6) Tile(rand(Third)) Tile(rand(Fourth)) #end
#declare Copy = First;
#for (I, 1, 4) Tile(rand(First)) Tile(rand(Copy)) #end
#declare First = seed(1);
#for (I, 1, 6) Tile(rand(First)) #end
#declare Zero = seed(0);
#for (I, 1, 6) Tile(rand(Zero)) #end
#for (I, 1, 1000) #declare Skipped = rand(Zero); #end
#for (I, 1, 6) Tile(rand(Zero)*100) #end
