// #while: nested, ended by #break, never entered, counting down.
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

#declare I = 0;
#while (I < 10) Tile(I*0.1) #declare I = I + 1; #end
#while (0) Tile(0.9) #end
#declare I = 3;
#while (I > 0)
  #declare J = 0;
  #while (J < I) Tile(0.3*I + 0.05*J) #declare J = J + 1; #end
  #declare I = I - 1;
#end
#declare I = 0;
#while (true)
  #declare I = I + 1;
  #if (I = 4) #break #end
  Tile(I*0.17)
#end
Tile(I*0.17)
#declare V = <0.1, 0.2, 0.3>;
#while (vlength(V) < 2) Tiles(V) #declare V = V*1.5; #end
#declare X = 1; #while (X > 0.01) #declare X = X/2; Tile(X) #end
