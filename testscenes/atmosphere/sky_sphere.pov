// The sky of missing and of mirrored rays: layers, transformations, emission, background behind.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at <0, 1, 0> angle 70 }
light_source { <20, 30, -20> rgb 1 }
background { rgb <0.1, 0.3, 0.1> }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.4>] [0.4 rgbt <0.2, 0.4, 0.9, 0.2>] [1 rgbt <0, 0, 0.3, 0.6>] } }
  pigment { bozo turbulence 0.4 color_map { [0.3 rgbf <1, 0.9, 0.9, 1>] [0.7 rgbt <1, 1, 1, 0.2>] } scale <0.4, 0.15, 0.4> }
  emission rgb <1, 0.9, 1.2>
  rotate 20*z scale <1, 1.2, 1> translate 0.1*y
}
sphere { <-1.2, 1, 0>, 1 pigment { rgb 0.2 } finish { reflection { 0.8 } } }
sphere { <1.2, 1, 0>, 1 pigment { rgbf 0.9 } interior { ior 1.3 } }
plane { y, 0 pigment { checker rgb 0.3 rgb 0.6 } finish { reflection 0.2 } }
