// Spheres: whole, scaled to an ellipsoid, cut by the floor, far away, and around the camera.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

sphere { <-1.3, 0, 0>, 0.9 pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.6 phong_size 40 } }
sphere { 0, 1 scale <0.5, 1.1, 0.8> rotate 20*z translate <1.1, 0.2, 0> pigment { rgb <0.2, 0.7, 0.3> } }
sphere { <0.2, -1, -1.4>, 0.5 pigment { rgb <0.9, 0.8, 0.2> } }
sphere { <5, -2, 120>, 9 pigment { rgb <0.8, 0.5, 0.9> } }
sphere { <0, 0, 0>, 400 pigment { rgb <0.4, 0.5, 0.8> } finish { ambient 0.6 diffuse 0 } }
