#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
light_source { <3, 3, -3>, 1 area_light x, y, 100000, 100000 }
// expect error 4:47: an 'area_light' may have at most 1048576 points
