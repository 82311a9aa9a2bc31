// Numbers in every form: .5, 5., exponents, signs, and those that only look alike.
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

Tile(.5) Tile(0.25) Tile(7.) Tile(1e-1) Tile(1.25E1) Tile(.5e1) Tile(2.5e+0) Tile(1000000.3) Tile(0.000001) Tile(1e3)
Tile(-.25) Tile(-0) Tile(+0.75) Tile(--0.5) Tile(-1.5e-1) Tile(00.70) Tile(12.3456789012345678) Tile(0*7 + 0.3) Tile(1e10) Tile(3.3)
Tile(true) Tile(false) Tile(yes) Tile(no) Tile(on) Tile(off) Tile(pi) Tile(clock) Tile(version)
Tile(image_width/7) Tile(image_height/7) Tile(image_width/image_height) Tile(frame_number/3) Tile(final_frame/3) Tile(clock_delta) Tile(clock_on)
