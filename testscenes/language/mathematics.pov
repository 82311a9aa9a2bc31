// The everyday functions of numbers and vectors.
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

Tile(abs(-0.3)) Tile(acos(0.3)) Tile(asin(0.3)) Tile(atan2(1, 2)) Tile(atan(0.7)) Tile(ceil(1.2)/7) Tile(cos(1)) Tile(cosh(0.6)) Tile(degrees(1)) Tile(div(17, 5)/7)
Tile(exp(0.7)) Tile(floor(-1.2)/7) Tile(int(2.7)/7) Tile(int(-2.7)/7) Tile(ln(5)) Tile(log(5)) Tile(max(0.3, 0.7, 0.5)) Tile(min(0.3, 0.7, 0.2)) Tile(mod(7.3, 2)) Tile(mod(-7.3, 2))
Tile(pow(2, 0.3)) Tile(pow(0.3, 2)) Tile(radians(50)) Tile(sin(1)) Tile(sinh(0.5)) Tile(sqrt(0.7)) Tile(tan(0.7)) Tile(tanh(0.7)) Tile(asinh(0.7)) Tile(acosh(1.7))
Tile(atanh(0.7)) Tile(select(-1, 0.2, 0.7)) Tile(select(0, 0.2, 0.4, 0.9)) Tile(select(3, 0.2, 0.4, 0.9)) Tile(select(0, 0.2, 0.6)) Tile(bitwise_and(13, 6)/7) Tile(bitwise_or(9, 6)/31) Tile(bitwise_xor(13, 6)/31) Tile(atan2(0, -1)) Tile(atan2(0, -1)/7)
Tile(vlength(<1, 2, 3>)) Tile(vdot(<1, 2, 3>, <0.1, 0.4, 0.2>)) Tiles(vcross(<1, 2, 3>, <0.3, 0.1, 0.7>)) Tiles(vnormalize(<1, 2, 3>)) Tile(vlength(<3, 4>)/7) Tile(0.1)
Tiles(vrotate(<0.1, 0.5, 0.9>, <30, 40, 50>)) Tiles(vaxis_rotate(<0.1, 0.5, 0.9>, <1, 1, 0>, 70)) Tiles(vrotate(x, 30*z)) Tile(0.2)
Tiles(vaxis_rotate(y, x, -20)) Tiles(vnormalize(vcross(x + y, z))) Tile(pow(4, -0.5)) Tile(log(0.02) + 2) Tile(defined(Tile_Count)*0.4) Tile(defined(Nobody)*0.4)
Tile(int(0.9999999999)) Tile(ceil(-0.2)) Tile(mod(6, 3)) Tile(radians(degrees(0.4))) Tile(exp(ln(0.6))) Tile(pow(-2, 3)/7) Tile(atan2(-1, -2)) Tile(abs(0.4)) Tile(min(0.4, 0.4)) Tile(max(1, 0.4))
