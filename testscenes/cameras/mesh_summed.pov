// Method 1: the faces of two meshes one after the other, and pixels without a face; rays of limited length, backwards.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
light_source { <-4, 6, -5>, rgb 1 }
#declare Scene = union {
  plane { y, -1.5 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
  sphere { <0, 0.2, 3>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { reflection 0.2 } }
  box { <1.8, -1.5, 2>, <2.8, 1.5, 3> pigment { rgb <0.3, 0.7, 0.9> } }
  cone { <-2.4, -1.5, 3>, 0.8, <-2.4, 1.2, 3>, 0 pigment { rgb <0.6, 0.9, 0.3> } }
}
object { Scene }
// A face a pixel, on a curved screen, row by row.
#macro Faces(Width, Height, Offset)
  #local J = 0;
  #while (J < Height)
    #local I = 0;
    #while (I < Width)
      #local U = (I + 0.5)/Width - 0.5;
      #local V = 0.5 - (J + 0.5)/Height;
      #local P = <1.5*U, 1.1*V, 0.3*U*U - 0.2*V> + Offset;
      #local D = vnormalize(<1.2*U, 0.9*V, 1>);
      #local A = vnormalize(vcross(y, D));
      #local B = vcross(D, A);
      triangle { P - 0.01*A - 0.01*B, P + 0.01*A - 0.01*B, P + 0.02*B }
      #local I = I + 1;
    #end
    #local J = J + 1;
  #end
#end

camera {
  mesh_camera {
    2 1 4.5
    mesh { Faces(image_width, floor(image_height/2), <0, 0.2, 0>) rotate 180*y scale <1, 1.3, 1> translate <0, 0, 1> }
    mesh { Faces(image_width, floor(image_height/3), <0, -0.2, 0>) rotate 180*y scale <0.8, 1, 1> }
  }
  location <0, 0, -0.1>
  direction <0, 0, -1>
}
fog { fog_type 1 distance 30 rgb <0.8, 0.8, 0.9> }
