#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { rgb 1 } normal { bump_map { png "none.png" } } }
// expect error 4:57: there is no file 'none.png' in the current folder, the scene's or the library folders
