#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { bozo color_map { } } }
// expect error 4:42: expected '[' and an entry of the map, found '}'
