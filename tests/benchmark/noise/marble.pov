// How fast noise is, see docs/performance.md: a plane that is only coloured, less the one of gradient.pov.
#version 3.7;
#ifndef (Generator) #declare Generator = 2; #end
global_settings { assumed_gamma 1 noise_generator Generator }
camera { location <0, 0, -10> look_at 0 angle 60 }
plane { z, 0 pigment { marble turbulence 0.8 } finish { ambient 1 diffuse 0 } }
