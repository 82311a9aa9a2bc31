#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
#declare N = 1e308*1e308;
mesh2 { vertex_vectors { 3, <N - N, 0, 0>, x, y } face_indices { 1, <0, 1, 2> } }
// expect error 5:29: corner of 'mesh2' has a component that is not a finite number
