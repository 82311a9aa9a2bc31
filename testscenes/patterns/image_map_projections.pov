// The ways in which pictures are laid round: spherical, cylindrical, toroidal; once and repeated.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }

sphere { 0, 1 pigment { image_map { png "images/rgb.png" map_type 1 interpolate 2 } rotate <20, 30, 0> } translate <-2, 1.1, 0> }
cylinder { <0, -0.2, 0>, <0, 1.2, 0>, 0.9 pigment { image_map { png "images/rgb.png" map_type 2 } } rotate -30*x translate <0.1, 0.5, 0> }
torus { 1, 0.4 pigment { image_map { png "images/rgb.png" map_type 5 interpolate 3 } } rotate -60*x translate <2.2, 1, 0> }
sphere { 0, 1 pigment { image_map { gif "images/palette.gif" map_type 1 once } } translate <-2, -1.1, 0> }
cylinder { <0, -0.5, 0>, <0, 1.5, 0>, 0.9 pigment { image_map { gif "images/palette.gif" map_type 2 once interpolate 2 } } translate <0.1, -1.6, 0> }
box { -0.9, 0.9 pigment { image_map { png "images/rgb.png" once } } rotate <-20, 30, 0> translate <2.2, -1.1, 0> }
plane { z, 4 pigment { checker rgb 0.2 rgb 0.4 } }
