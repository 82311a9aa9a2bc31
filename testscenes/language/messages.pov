// #debug, #warning and #version do not change the picture; reserved words and names in all letters.
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

#debug "A message for the person who debugs.\n"
#debug concat("Pi is ", str(pi, 0, 5), "\n")
#warning "A warning that does not matter.\n"
#version 3.7;
#declare Version_Here = version;
#version 3.6;
#declare Version_There = version;
#version Version_Here;
Tile(Version_Here/7) Tile(Version_There/7) Tile(version/7)
#declare _Underscore = 0.3;
#declare Name_With_9_Digits_123 = 0.6;
#declare X = 0.2;
#declare Sphere = 0.8;
Tile(_Underscore) Tile(Name_With_9_Digits_123) Tile(X) Tile(Sphere)
