#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
lathe { cubic_spline 2, <0, 0>, <1, 1> }
// expect error 4:22: expected at least 4 points of 'lathe', found 2
