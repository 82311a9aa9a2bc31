// Operators: their order, unary minus, comparison, logic, the conditional, and vectors of numbers.
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

#declare A = 2.4;
#declare B = 0.7;
#declare Paint = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
Tile(1 + 2*0.3) Tile((1 + 2)*0.3) Tile(7/2/5) Tile(7 - 2 - 0.6) Tile(-A*B) Tile(A - -B) Tile(2*3 + 4/5 - 6*0.7) Tile(-pow(2, 0.5)) Tile(A/B*0.3) Tile(-(A + B))
Tile((A > B)) Tile((A < B)) Tile((A >= 2.4)) Tile((A <= 2.3)) Tile((A = 2.4)) Tile((A != B)) Tile((1 < 2 & 3 < 2)) Tile((1 < 2 | 3 < 2)) Tile((!1)) Tile((!0 + 0.3))
Tile((A > B ? 0.3 : 0.6)) Tile((A < B ? 0.3 : 0.6)) Tile((0 ? 0.1 : 1 ? 0.2 : 0.3)) Tile(((A > 2 & B < 1) ? 0.7 : 0.2)) Tile((1 | 0 & 0)) Tile(((1 | 0) & 0)) Tile((0.5 & 0.25)) Tile((!A = 0)) Tile((2 + 3 > 4)) Tile((1 - 1 | 0.4))
Tiles(<1, 2, 3>*0.3) Tiles(<0.1, 0.2, 0.3> + 0.2) Tiles(<1, 2, 3>/<2, 4, 8>) Tile(<1, 2, 3>.y*0.3)
Tiles(-<0.1, 0.2, 0.3>) Tiles(x + 0.5*y + z*0.2) Tiles(<1, 2, 3>*<0.2, 0.4, 0.3> - 0.1*z) Tile(x.x*0.4)
Tiles(2 - <0.1, 0.2, 0.3>) Tiles(<A, B, A*B>) Tiles((1 > 0 ? <0.1, 0.5, 0.9> : <0, 0, 0>)) Tile((<0.2, 0.7> + <0.1, 0.1>).u)
Tile(<0.2, 0.7>.v) Tile(<0.1, 0.2, 0.3, 0.4>.t) Tile(Paint.filter) Tile(Paint.transmit) Tile(Paint.green)
Tile((<1, 2, 3, 4, 5>*0.15).transmit) Tile((<0.1, 0.2> + 0.3).y) Tile((vlength(<1, 2, 3>) = vlength(<3, 2, 1>))) Tile(<0.1, 0.2, 0.3>.z) Tile((x + y).y*0.6)
