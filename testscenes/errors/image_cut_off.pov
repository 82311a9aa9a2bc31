#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { image_map { png "parts/cut.png" } } }
// expect error 4:37: the file ends too early
