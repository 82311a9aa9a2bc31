#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
mesh2 { vertex_vectors { 4, 0, x, y } face_indices { 1, <0, 1, 2> } }
// expect error 4:37: expected a numeric expression, found '}'
