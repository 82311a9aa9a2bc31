#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { image_map { png "parts/empty.png" } } }
// expect error 4:37: Not a PNG file
