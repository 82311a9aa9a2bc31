// A field of spheres, each placed, sized and coloured by chance, as scenes do.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare R = seed(4711);
#for (I, 1, 120)
  sphere {
    <7*rand(R) - 3.5, -1 + 0.3*rand(R), 5*rand(R) - 2.5>, 0.08 + 0.25*rand(R)
    pigment { rgb <rand(R), rand(R), rand(R)> }
    finish { phong rand(R) }
  }
#end
