#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { density_file df3 "parts/huge.df3" } }
// expect error 4:42: its size is not that of its densities
