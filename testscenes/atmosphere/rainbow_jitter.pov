// compare: psnr 35
// A bow whose jitter is a small part of its width.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -8> look_at <0, 3, 0> angle 90 }
background { rgb <0.3, 0.4, 0.6> }
rainbow {
  angle 30 width 12 distance 10 jitter 0.03 direction <0, -0.1, 1>
  color_map { [0 rgbt <0.5, 0.2, 0.8, 1>] [0.3 rgbt <0.2, 0.3, 1, 0.6>] [0.7 rgbt <1, 1, 0.2, 0.6>] [1 rgbt <1, 0.1, 0.1, 1>] }
}
plane { y, 0 pigment { rgb 0.3 } }
