#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
blob { threshold 1 }
// expect error 4:1: 'blob' needs at least one 'sphere', 'cylinder' or 'component'
