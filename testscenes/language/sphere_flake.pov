// A recursive macro that builds a small sphere-flake, as scenes of the time do.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#macro Flake(Center, Radius, Axis, Depth)
  sphere { Center, Radius }
  #if (Depth > 0)
    #local Small = Radius/2.6;
    #local Side = vnormalize(vcross(Axis, (abs(Axis.y) < 0.9 ? y : x)));
    #for (I, 0, 5)
      #local Out = vaxis_rotate(Side, Axis, 60*I);
      Flake(Center + (Radius + Small)*Out, Small, Out, Depth - 1)
    #end
    Flake(Center + (Radius + Small)*Axis, Small, Axis, Depth - 1)
  #end
#end
union {
  Flake(<0, 0, 0>, 0.8, y, 3)
  pigment { rgb <0.9, 0.6, 0.3> }
  finish { phong 0.6 reflection 0.15 }
}
