// Smooth triangles: their normals are interpolated, as the highlights show; a coarse ball and one alone.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Rows = 5;
#declare Columns = 8;
#macro Point(I, J) vrotate(vrotate(y, 180*I/Rows*x), 360*J/Columns*y) #end
union {
  #for (I, 0, Rows - 1)
    #for (J, 0, Columns - 1)
      #declare A = Point(I, J);
      #declare B = Point(I + 1, J);
      #declare C = Point(I + 1, J + 1);
      #declare D = Point(I, J + 1);
      #if (I < Rows - 1) smooth_triangle { A, A, B, B, C, C } #end
      #if (I > 0) smooth_triangle { A, A, C, C, D, D } #end
    #end
  #end
  pigment { rgb <0.3, 0.6, 0.9> }
  finish { phong 0.8 phong_size 30 }
  scale 1.1
  translate <-1, 0.1, 0>
}
smooth_triangle {
  <0.4, -0.9, 0>, <-1, 0, -1>, <2.2, -0.8, -0.2>, <1, 0.2, -0.6>, <1.3, 1.3, 0.2>, <0, 1, -0.5>
  pigment { rgb <0.9, 0.5, 0.2> } finish { specular 0.8 roughness 0.02 }
}
