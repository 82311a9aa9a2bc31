#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
prism { 0, 1, 2, <0, 0>, <1, 1> }
// expect error 4:15: expected at least 3 points of 'prism', found 2
