#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
height_field { function 100000, 100000 { x } }
// expect error 4:1: the picture of 'height_field' cannot be used: it has too many rows and columns
