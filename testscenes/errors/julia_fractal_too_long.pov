#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
julia_fractal { 0 max_iteration 1000000000 }
// expect error 4:33: 'max_iteration' of 'julia_fractal' must be at most 100000
