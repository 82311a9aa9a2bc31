#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
poly { 3, <1, 2> }
// expect error 4:16: expected a numeric expression, found '>'
