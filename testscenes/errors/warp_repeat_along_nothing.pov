#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { bozo warp { repeat 0*x } } }
// expect error 4:44: 'repeat' goes along one axis, x, y or z
