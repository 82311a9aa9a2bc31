#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
text { ttf "none.ttf" "A" 1, 0 }
// expect error 4:12: there is no file 'none.ttf' in the current folder, the scene's or the library folders
