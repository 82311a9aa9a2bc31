// Everything that can be declared: numbers to lights, each used under its name.
#version 3.7;
global_settings { assumed_gamma 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare A_Number = 0.4;
#declare A_Vector = <0.4, 0.5, 0.6>;
#declare A_Point = <0.3, 0.7>;
#declare A_Colour = rgbft <0.9, 0.5, 0.2, 0.1, 0.05>;
#declare A_String = "text";
#declare A_Map = color_map { [0 rgb 0.2] [1 A_Colour] }
#declare A_Pigment = pigment { gradient y color_map { A_Map } scale 0.7 }
#declare A_Finish = finish { ambient 0.2 diffuse 0.6 phong 0.5 }
#declare A_Texture = texture { A_Pigment finish { A_Finish } }
#declare An_Interior = interior { ior 1.3 }
#declare A_Material = material { texture { pigment { rgbt <0.8, 0.9, 1, 0.8> } } interior { An_Interior } }
#declare A_Transform = transform { rotate 20*z translate 0.3*y }
#declare A_Shape = sphere { 0, 0.5 }
#declare A_Difference = difference { object { A_Shape } box { 0, 1 } }
#declare A_Light = light_source { <-4, 6, -5>, rgb A_Number }
#declare A_Camera = camera { location <0, 2, -6> look_at 0.3*y right x*4/3 angle 45 }
#declare An_Array = array[2] { A_Shape, A_Shape }
#declare Another_Number = A_Number + 0.1;
camera { A_Camera }
light_source { A_Light }
light_source { A_Light translate 8*x }
object { A_Shape texture { A_Texture } translate -1.6*x }
object { A_Difference pigment { A_Pigment } transform { A_Transform } translate -0.5*x }
object { An_Array[1] material { A_Material } translate <0.6, 0, 0> }
object { A_Shape pigment { color A_Colour } finish { A_Finish } scale A_Vector translate <1.7, Another_Number - 0.5, 0> }
box { -0.3, 0.3 pigment { rgb <A_Point.x, A_Point.y, A_Vector.z> } translate <0, -0.7, -1.5> }
#if (strcmp(A_String, "text") = 0) torus { 0.3, 0.1 texture { A_Texture } translate <1.2, -0.8, -1.2> } #end
