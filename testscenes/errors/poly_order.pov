#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
poly { 99, <1, 2> }
// expect error 4:8: the order of 'poly' must be from 2 to 35
