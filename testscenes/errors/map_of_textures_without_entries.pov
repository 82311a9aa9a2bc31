#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 texture { bozo texture_map { } } }
// expect error 4:44: expected '[' and an entry of the map, found '}'
