// The surface's own coordinates of every shape that has some, and what the others take instead.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -60> look_at 0 right x*4/3 angle 13 }
light_source { <-20, 30, -50> rgb 1 }
light_source { <30, 10, -50> rgb 0.4 shadowless }
#default { finish { ambient 0.2 diffuse 0.6 } }
#declare Marks = texture { pigment { uv_mapping gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <1, 0.9, 0.2>] [1 rgb <0.1, 0.3, 0.8>] } warp { repeat y/8 offset x/16 } scale 0.35 } }
#declare N = 0;
#macro Place(Shape, Size)
  object { Shape uv_mapping texture { Marks } rotate <-25, 35, 10> scale Size translate <2.1*mod(N, 6) - 5.25, 4.1 - 2.05*floor(N/6), 0> }
  #declare N = N + 1;
#end
Place(sphere { 0, 0.9 }, 1)
Place(box { -0.65, 0.65 }, 1)
Place(torus { 0.6, 0.3 }, 1)
Place(cone { -0.8*y, 0.7, 0.8*y, 0.2 }, 1)
Place(cylinder { -0.7*y, 0.7*y, 0.6 }, 1)
Place(disc { 0, z, 0.9, 0.3 }, 1)
Place(lathe { cubic_spline 6, <0.1, -1.2>, <0.4, -0.8>, <0.8, -0.2>, <0.4, 0.3>, <0.6, 0.8>, <0.9, 1> }, 0.9)
Place(sor { 6, <0.1, -1.2>, <0.4, -0.8>, <0.8, -0.2>, <0.4, 0.3>, <0.6, 0.8>, <0.9, 1> }, 0.9)
Place(ovus { 0.6, 0.35 translate -0.3*y }, 1)
Place(prism { linear_spline -0.5, 0.5, 5, <-0.7, -0.7>, <0.7, -0.5>, <0.4, 0.2>, <-0.3, 0.8>, <-0.7, -0.7> }, 1)
Place(superellipsoid { <0.4, 0.6> scale 0.7 }, 1)
Place(bicubic_patch { type 1 flatness 0.001 u_steps 4 v_steps 4 uv_vectors <0, 0> <1, 0> <1, 1> <0, 1>
  <-0.9, -0.9, 0>, <-0.3, -0.9, 0.8>, <0.3, -0.9, -0.8>, <0.9, -0.9, 0>, <-0.9, -0.3, 0.4>, <-0.3, -0.3, 0>, <0.3, -0.3, 0>, <0.9, -0.3, 0.4>,
  <-0.9, 0.3, 0>, <-0.3, 0.3, 0.3>, <0.3, 0.3, 0.5>, <0.9, 0.3, 0>, <-0.9, 0.9, 0>, <-0.3, 0.9, -0.8>, <0.3, 0.9, 0.8>, <0.9, 0.9, 0> }, 1)
Place(mesh { triangle { <-0.9, -0.8, 0>, <0.9, -0.8, 0>, <0, 0.9, 0> uv_vectors <0, 0>, <1, 0>, <0.5, 1> }
  smooth_triangle { <-0.9, 0.8, 0>, -z, <0.9, 0.8, 0.4>, <0.3, 0.2, -1>, <0.6, 1.2, -0.3>, y - z uv_vectors <0.2, 0>, <1.3, 0>, <0.5, 0.7> } }, 0.9)
Place(mesh2 { vertex_vectors { 4, <-0.8, -0.8, 0>, <0.8, -0.8, 0>, <0.8, 0.8, 0.3>, <-0.8, 0.8, 0> }
  uv_vectors { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0.5, 0.5> } face_indices { 2, <0, 1, 2>, <0, 2, 3> } uv_indices { 2, <0, 1, 4>, <0, 2, 3> } }, 1)
Place(parametric { function { u*cos(v)*0.8 }, function { u*sin(v)*0.8 }, function { 0.4*u*u } <0, 0>, <1, 2*pi> contained_by { box { -1, 1 } } max_gradient 4 accuracy 0.001 precompute 12, x, y, z }, 1)
Place(height_field { function 20, 20 { sin(x*9)*sin(y*7)*0.5 + 0.5 } smooth translate -0.5 scale <1.6, 0.4, 1.6> rotate -40*x }, 1)
Place(polygon { 6, <-0.8, -0.6>, <0.8, -0.8>, <0.6, 0.4>, <0, 0.9>, <-0.6, 0.5>, <-0.8, -0.6> }, 1)
Place(text { ttf "crystal.ttf" "A" 0.3, 0 translate <-0.3, -0.3, 0> scale 2 }, 1)
Place(sphere_sweep { b_spline 6, <-1.4, 0, 0>, 0.2, <-0.8, 0, 0>, 0.3, <-0.3, 0.6, 0>, 0.2, <0.3, -0.4, 0>, 0.3, <0.8, 0.4, 0>, 0.2, <1.2, 0, 0>, 0.2 }, 1)
Place(blob { threshold 0.5 sphere { -0.3*x, 0.9, 1 } cylinder { <0.2, -0.5, 0>, <0.4, 0.5, 0>, 0.5, 1 } }, 1)
Place(quadric { <1, 2, 1>, <0, 0.2, 0>, 0, -0.5 clipped_by { box { -0.7, 0.7 } } }, 1)
Place(isosurface { function { x*x + y*y + z*z*2 - 0.6 } contained_by { box { -0.8, 0.8 } } max_gradient 6 }, 1)
Place(difference { box { -0.6, 0.6 } sphere { <0.5, 0.5, -0.5>, 0.7 } }, 1)
Place(intersection { sphere { -0.2*x, 0.8 } cylinder { -y, y, 0.6 } plane { <1, 0, -1>, 0.4 } }, 1)
Place(julia_fractal { <-0.08, 0, -0.6, 0> quaternion sqr max_iteration 6 precision 40 scale 0.7 }, 1)
Place(triangle { <-0.9, -0.8, 0>, <0.9, -0.8, 0>, <0, 0.9, 0> }, 1)
Place(union { sphere { <-0.4, 0, 0>, 0.5 } box { <0, -0.4, -0.4>, <0.8, 0.4, 0.4> } }, 1)
Place(merge { sphere { <-0.4, 0, 0>, 0.5 } box { -0.3, <0.8, 0.4, 0.4> } }, 1)
