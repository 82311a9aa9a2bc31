// Comments of both kinds, nested ones, and marks of comments inside strings and after directives.
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

// Tile(0.9) /* not open
/* Tile(0.9) */ Tile(0.1) /* one /* inside */ another, // still closed by */ Tile(0.2)
Tile(/* here */ 0.3 // and there
)
#declare S = "// no /* comment */ here";
Tile(strlen(S)/31)
#if /* odd */ (1) // true
  Tile(0.5) /**/ Tile(0.6) /***/ Tile(0.7) /* * / */ Tile(0.8)
#end /* the end */ // really
#declare /* a name */ Odd /* is */ = /* this */ 0.35 /* value */ ; Tile(Odd)//no space
# declare Spaced = 0.45; Tile(Spaced)
#
if (1) Tile(0.55) # end
