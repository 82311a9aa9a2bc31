#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere_sweep { cubic_spline 2, 0, 1, x, 1 }
// expect error 4:29: expected at least 4 spheres, found 2
