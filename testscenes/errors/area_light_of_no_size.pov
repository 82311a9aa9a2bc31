#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
light_source { <3, 3, -3>, 1 area_light x, y, 0, -4 }
// expect error 4:47: the sizes of 'area_light' must be above 0
