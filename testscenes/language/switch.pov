// #switch with #case, #range, #else, #break and falling through; nested.
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

#macro Choose(N)
  #switch (N)
    #case (1) Tile(0.1) #break
    #case (2) Tile(0.2)
    #case (3) Tile(0.3) #break
    #range (4, 6) Tile(0.4) #break
    #range (6.5, 8) Tile(0.5)
    #else Tile(0.9)
  #end
#end
Choose(1) Choose(2) Choose(3) Choose(4) Choose(5.5) Choose(6) Choose(6.2) Choose(7) Choose(9) Choose(-1)
#switch (2) #case (1) Tile(0.15) #break #end
#switch (5)
  #case (5)
    #switch (1) #case (1) Tile(0.35) #break #case (2) Tile(0.45) #end
    Tile(0.65)
  #break
  #else Tile(0.75)
#end
#switch (0.5) #range (0, 1) #if (1) Tile(0.55) #break #end Tile(0.85) #end
