#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
text { ttf "parts/cut.ttf" "A" 1, 0 }
// expect error 4:8: it is no TrueType font
