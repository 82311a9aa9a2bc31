// White light split into bands: by a prism, by glass within other glass, in few bands and in many, and where it is totally reflected.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgb 0.02 }
camera { location <0, 1.5, -7> look_at <0, 0.2, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
#default { finish { diffuse 0.1 } }
#declare Clear = texture { pigment { rgbt 0.97 } finish { diffuse 0 } }
plane { z, 4 pigment { gradient x color_map { [0.85 rgb 0.05] [0.85 rgb 1] } } finish { ambient 1 diffuse 0 } }
plane { y, -1 pigment { checker rgb 0.7, rgb 0.1 } finish { ambient 0.8 diffuse 0 } }
prism { 0, 2.2, 4, <-0.9, -0.4>, <0.9, -0.4>, <0, 0.9>, <-0.9, -0.4>
  rotate <0, 20, 0> translate <-2.2, -1, 0> texture { Clear } interior { ior 1.5 dispersion 1.08 } }
sphere { <0.1, 0, 0>, 1 texture { Clear } interior { ior 1.45 dispersion 1.1 dispersion_samples 12 } }
sphere { <0.1, 0, -0.2>, 0.55 texture { Clear } interior { ior 1.8 dispersion 1.02 dispersion_samples 3 } }
box { <-0.7, -0.7, -0.7>, 0.7 rotate <20, 40, 30> translate <2.3, 0.2, 0>
  texture { Clear finish { diffuse 0 reflection 0.2 } } interior { ior 1.7 dispersion 1.15 dispersion_samples 2 } }
sphere { <-0.9, -0.6, -2>, 0.35 texture { Clear } interior { ior 1 dispersion 1.3 } }
sphere { <1.1, -0.6, -2>, 0.35 texture { Clear } interior { dispersion 1.3 fade_distance 1 fade_power 1 } }
