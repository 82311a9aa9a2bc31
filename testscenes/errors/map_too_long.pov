#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { bozo color_map { #for (I, 0, 300) [I/300 rgb I/300] #end } } }
// expect error 4:59: a 'color_map' has at most 256 entries
