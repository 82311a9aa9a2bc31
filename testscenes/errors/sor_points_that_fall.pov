#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sor { 4, <0.1, 0>, <0.5, 1>, <0.5, 0.5>, <0.3, 2> }
// expect error 4:1: the points of 'sor' must rise: each second number must be above the one before
