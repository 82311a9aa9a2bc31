// #if, #ifdef, #ifndef, #else, #elseif, skipped parts that would not parse, and expressions that choose.
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

#if (1) Tile(0.1) #else Tile(0.9) #end
#if (0) Tile(0.9) #else Tile(0.2) #end
#if (0) Tile(0.9) #elseif (1) Tile(0.3) #else Tile(0.9) #end
#if (0) Tile(0.9) #elseif (0) Tile(0.8) #elseif (2 > 1) Tile(0.4) #elseif (1) Tile(0.7) #end
#if (0) Tile(0.9) #elseif (0) Tile(0.8) #else Tile(0.5) #end
#ifdef (Nobody) Tile(0.9) #else Tile(0.6) #end
#declare Somebody = 1;
#ifdef (Somebody) Tile(0.7) #end
#ifndef (Nobody) Tile(0.8) #end
#undef Somebody
#ifndef (Somebody) Tile(0.15) #end
#if (0)
  this { is not < a scene ) #if (1) "nor #end is this" #else /* #end */ #end // #end
  #macro Skipped() #while (1) #end #end
  #switch (1) #case (1) #end
#end
#if (1) #if (0) Tile(0.9) #else #if (1) Tile(0.25) #end #end #end
#if (0.0001) Tile(0.35) #end
#if (-1) Tile(0.45) #end
sphere { <0, -1, 0>, #if (1) 0.3 #else 0.9 #end pigment { rgb #ifdef (Nobody) 1 #else <0.9, 0.4, 0.1> #end } }
#declare List = array[2] { 1, 2 };
#ifdef (List[1]) Tile(0.55) #end
