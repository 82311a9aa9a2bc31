// #for: forwards, backwards, in fractions, nested, ended by #break; its variable stays local to the loop.
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

#for (I, 1, 5) Tile(I*0.13) #end
#for (I, 5, 1, -2) Tile(I*0.13) #end
#for (I, 0, 1, 0.25) Tile(I*0.9) #end
#for (I, 3, 1) Tile(0.99) #end
#for (I, 0, 2) #for (J, I, 3) Tile(0.21*I + 0.04*J) #end #end
#for (I, 1, 100) #if (I > 3) #break #end Tile(I*0.29) #end
#for (I, 1, 3) #declare Kept = I; #end
Tile(Kept*0.23)
#declare N = 3;
#for (I, 1, N) #declare N = 6; Tile(I*0.07) #end
#for (I, 0.1, 0.5, 0.1) Tile(I) #end
