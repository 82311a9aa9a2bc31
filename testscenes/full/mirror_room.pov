// The scene of Yagel and Meeker, "Priority-driven Ray Tracing" (1997): a sphere-flake in a room of mirrors, with three
// lights and five levels. The flake has 7,381 spheres: one, and nine smaller ones on each, four times (1 + 9 + 81 + 729 + 6561).
// Other numbers of lights (1 to 3) and levels are set on the command line: declare=Lights=1 declare=Levels=3

#version 3.7;
#ifndef (Lights) #declare Lights = 3; #end
#ifndef (Levels) #declare Levels = 5; #end
global_settings { assumed_gamma 1 max_trace_level Levels }

camera {
  location <3.1, 1.25, -4.1>
  look_at <-0.45, -0.35, 0.3>
  right x*image_width/image_height
  angle 56
}

light_source { <3.2, 3.6, -3.6>, rgb <0.95, 0.85, 0.7> }
#if (Lights > 1) light_source { <-3.6, 2.8, -2.4>, rgb <0.2, 0.32, 0.6> } #end
#if (Lights > 2) light_source { <-0.6, 3.2, 3.7>, rgb <0.65, 0.3, 0.25> } #end

// ---- The room: a checkered floor, a ceiling, and four walls of mirror --------------------------------------------
#declare Mirror = texture {
  pigment { rgb <0.25, 0.45, 0.75> }
  finish { ambient 0.03 diffuse 0.03 reflection { rgb <0.78, 0.84, 0.88> } }
}
plane {
  y, -2
  pigment { checker rgb <0.6, 0.55, 0.46>, rgb <0.04, 0.07, 0.12> scale 0.8 }
  finish { ambient 0.03 diffuse 0.65 specular 0.3 roughness 0.02 reflection 0.1 }
}
plane { -y, -4 pigment { rgb <0.12, 0.16, 0.24> } finish { ambient 0.15 diffuse 0.5 } }
plane { x, -4.2 texture { Mirror } }
plane { -x, -4.2 texture { Mirror } }
plane { z, -5 texture { Mirror } }
plane { -z, -4.6 texture { Mirror } }

// ---- The sphere-flake ----------------------------------------------------------------------------------------------
// Each sphere carries nine of a third of its size: six around its equator and three nearer to its pole, which points
// away from the sphere that carries it.
#macro Flake(Center, Radius, Pole, Depth)
  sphere { Center, Radius }
  #if (Depth > 0)
    #local Small = Radius/3;
    #local Side = vnormalize(vcross(Pole, (abs(Pole.x) < 0.9 ? x : y)));
    #for (I, 0, 5)
      #local Out = vaxis_rotate(Side, Pole, 60*I);
      Flake(Center + (Radius + Small)*Out, Small, Out, Depth - 1)
    #end
    #for (I, 0, 2)
      #local Tilted = vaxis_rotate(Pole, Side, 52);
      #local Out = vaxis_rotate(Tilted, Pole, 120*I + 30);
      Flake(Center + (Radius + Small)*Out, Small, Out, Depth - 1)
    #end
  #end
#end

union {
  Flake(<0, 0, 0>, 1, y, 4)
  pigment { rgb <0.9, 0.5, 0.16> }
  finish { ambient 0.03 diffuse 0.6 specular 0.6 roughness 0.015 reflection 0.2 }
  rotate <-12, 20, 8>
  translate -0.3*y
}
