// Strings: their functions, escapes and comparison.
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

#declare S = "Firstlight";
Tile(strlen(S)/7) Tile(strlen("")) Tile(asc("A")/7) Tile(asc(substr(S, 3, 1))/7) Tile(strlen(substr(S, 2, 5))/7) Tile((strcmp("abc", "abd") < 0)) Tile((strcmp("b", "a") > 0)) Tile(strcmp(S, "Firstlight")) Tile(val("0.7")) Tile(val("-1.25e1"))
Tile(val(str(0.4567, 0, 2))) Tile(strlen(str(3.14159, 0, 4))/7) Tile(strlen(str(3.14159, 12, 4))/7) Tile(asc(str(42, 0, 0))/7) Tile(val(str(12.5, 8, -1))/7) Tile(strlen(concat(S, " renders", " a scene"))/31) Tile(strcmp(strupr("abc"), "ABC")) Tile(strcmp(strlwr("ABC"), "abc")) Tile(asc(chr(77))/7) Tile(strlen("a\"b\\c\n")/7)
Tile(strlen(vstr(3, <1, 2, 3>, ", ", 0, 1))/31) Tile(strcmp(concat("a", "b"), "ab")) Tile(val(substr("x0.35y", 2, 4))) Tile(strlen(str(-0.5, 0, 3))/7) Tile(strlen(str(1e6, 0, 0))/7) Tile(asc("\\")/7) Tile(file_exists("strings.pov")*0.4) Tile(file_exists("no_such_file.pov")*0.4)
#declare Letters = "abcdefghijklmnop";
#for (I, 1, strlen(Letters)) Tile(asc(substr(Letters, I, 1))/13) #end
#if (strcmp(S, "Firstlight") = 0) Tile(0.3) #else Tile(0.8) #end
#debug concat("Count: ", str(Tile_Count, 0, 0), "\n")
