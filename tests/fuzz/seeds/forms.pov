// One of many forms of the language, where random changes may begin.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 ambient_light rgb 0.5 }
#declare Sizes = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } };
#local Name = concat("a", str(1.5, 5, 2), chr(98), substr("word", 2, 2), "\"quoted\"\n");
#macro Place(Thing, Count)
  #for (I, 0, Count - 1)
    object { Thing translate <I, sqr(I), mod(I, 2)> * 1.5 }
  #end
#end
#switch (strlen(Name))
  #case (3) #warning "three" #break
  #range (4, 20) #debug Name #break
  #else #error "never"
#end
#declare F = function(x, y, z) { sqrt(x * x + y * y) - select(z, 1, 2, 3) };
#declare Ball = sphere { 0, 1 pigment { gradient y color_map { [0 rgb x] [1 rgbt <0, 1, 0, .5>] } turbulence 0.1 } finish { phong .8 } }
#ifdef (Ball) Place(Ball, dimension_size(Sizes, 2)) #end
#while (Sizes[0][0] < 3) #declare Sizes[0][0] = Sizes[0][0] + 1; #end
#if (F(1, 2, 3) > 0 & !(Sizes[1][2] = 7) | pi != 3) background { color srgb <0.1, 0.2, 0.3> } #end
camera { location <0, 2, -6> look_at 0 angle 40 right x * image_width / image_height }
light_source { <5, 9, -8> color rgb 1 }
difference { box { -1, 1 } cylinder { -2 * x, 2 * x, 0.5 } rotate <0, 45, 0> texture { pigment { checker rgb 1, rgb 0 } } interior { ior 1.5 } }
