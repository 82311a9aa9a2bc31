// Macros: parameters by value and by reference, values that they give, fragments of syntax, recursion, local names.
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

#macro Twice(A) A*2 #end
#macro Sum(A, B) (A + B) #end
#macro Swap(A, B) #local T = A; #declare A = B; #declare B = T; #end
#macro Fibonacci(N) #if (N < 2) #local R = N; #else #local R = Fibonacci(N - 1) + Fibonacci(N - 2); #end R #end
#macro Vector(A) <A, A*2, A*3> #end
#macro Nothing() #end
Tile(Twice(0.15)) Tile(1 + Twice(0.1) + 0.2) Tile(Sum(0.1, 0.2)*2) Tiles(Vector(0.1)) Nothing()
#declare P = 0.2; #declare Q = 0.7;
Swap(P, Q)
Tile(P) Tile(Q) Tile(Fibonacci(12)/31) Tile(Twice(Twice(Twice(0.1))))
#macro Half() 0.5 #end
#macro Recurse(N, Text) #if (N > 0) Tile(0.13*N) Recurse(N - 1, concat(Text, "x")) #else Tile(strlen(Text)/7) #end #end
Recurse(5, "")
Tile(Half()) Tile(Half()*Half())
#macro Finish_And_Place(X) finish { emission 0.3 } translate X*x #end
#macro Open_Ball(R) sphere { 0, R pigment { rgb <0.3, 0.7, 0.9> } #end
Open_Ball(0.3) Finish_And_Place(-2) translate -1*y }
Open_Ball(0.2) Finish_And_Place(-1.2) translate -1*y }
#macro Make(Name, Value) #declare Name = Value; #end
#declare Made = 0;
Make(Made, 0.77)
Tile(Made)
#macro Outer(N) #macro Inner(M) M*3 #end Tile(Inner(N)) #end
Outer(0.11)
#declare Global_Value = 0.35;
#macro Hide() #local Global_Value = 0.9; Tile(Global_Value) #end
Hide() Tile(Global_Value)
#macro Optional(A) #ifdef (A) Tile(0.4) #else Tile(0.8) #end #end
#macro Object(Shape, Paint) object { Shape pigment { Paint } translate <1, -1, 0> } #end
Object(sphere { 0, 0.3 }, rgb <0.9, 0.5, 0.2>)
#macro Rows(N) #local I = 0; #while (I < N) Tile(I*0.09) #local I = I + 1; #end #end
Rows(4) Rows(3)
Tile(Sum(Twice(0.1), Sum(0.05, Half())))
