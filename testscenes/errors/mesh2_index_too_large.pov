#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 7> } }
// expect error 4:57: index 7 in 'face_indices' is out of range: there are 3
