// The camera is inside of matter: of a wall that is a plane, and of a ball of glass, which its rays leave first.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

plane { z, 6 pigment { checker rgb <0.7, 0.75, 0.9>, rgb <0.35, 0.3, 0.25> } }
sphere { <0, 1.6, -6>, 1 pigment { rgbt <1, 0.98, 0.95, 0.9> } finish { diffuse 0.1 } interior { ior 1.15 } }
sphere { <-1.1, 0.2, 0>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } } interior { ior 1.5 } }
box { -0.7, 0.7 rotate <20, 30, 0> translate <1.1, 0.2, 0> pigment { rgbt <0.9, 0.95, 1, 0.9> } finish { ambient 0.2 diffuse 0.1 reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.6 } }
