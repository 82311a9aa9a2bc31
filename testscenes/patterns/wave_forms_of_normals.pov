// Wave types, frequency and phase of normals, and of maps of slopes, normals, textures and pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 12*x up 9*y }
light_source { <-30, 40, -50> rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } pigment { rgb <0.9, 0.7, 0.4> } }
#declare N = 0;
#macro Tile(Wearing)
  box { <-0.93, -0.93, 0>, <0.93, 0.93, 0.1> texture { Wearing } translate <2*mod(N, 6) - 5, 3.2 - 2.1*floor(N/6), 0> }
  #declare N = N + 1;
#end
Tile(texture { normal { gradient x 0.7 ramp_wave frequency 2 phase 0.3 } })
Tile(texture { normal { radial 0.7 triangle_wave frequency 6 phase 0.2 rotate 90*x } })
Tile(texture { normal { onion 0.7 sine_wave frequency 3 phase 0.1 } })
Tile(texture { normal { wood 0.7 scallop_wave frequency 3 phase 0.6 } })
Tile(texture { normal { gradient <1, 1, 0> 0.7 cubic_wave frequency 2 phase -0.3 } })
Tile(texture { normal { gradient <1, 1, 0> 0.7 poly_wave 2.5 frequency 2 phase 0.4 } })
Tile(texture { normal { gradient x slope_map { [0 <0, 1>] [0.5 <1, 1>] [0.5 <1, 0>] [0.75 <0.3, -1>] [1 <0, 0>] } frequency 2 phase 0.2 scale 0.8 } })
Tile(texture { normal { bozo 0.8 slope_map { [0 <0, 1>] [0.6 <1, 0>] [1 <0, -1>] } triangle_wave frequency 3 } })
Tile(texture { normal { radial normal_map { [0 granite 0.4 scale 0.3] [0.5 wrinkles 0.7 scale 0.2] [1 dents 0.9 scale 0.2] } frequency 3 phase 0.4 sine_wave rotate 90*x } })
Tile(texture { pigment { leopard pigment_map { [0 checker rgb 0.1 rgb 0.9 scale 0.2] [0.6 rgb <0.8, 0.2, 0.1>] [1 granite] } scale 0.2 scallop_wave frequency 2 } })
Tile(texture { gradient y texture_map { [0.2 pigment { rgb x } finish { phong 1 }] [0.7 pigment { agate } normal { bumps 1 scale 0.1 }] } frequency 3 phase 0.5 triangle_wave })
Tile(texture { pigment { spiral1 4 color_map { [0 rgb 0] [0.4 rgb y] [0.4 rgb z] [1 rgb 1] } cubic_wave frequency 2 phase 0.15 scale 0.4 } })
Tile(texture { normal { waves 0.6 frequency 2 phase 0.7 scale 0.3 } })
Tile(texture { normal { ripples 0.6 frequency 3 phase 0.2 scale 0.5 } })
Tile(texture { normal { quilted 0.8 control0 0.3 control1 1.6 scale 0.6 } })
Tile(texture { normal { gradient x 0.8 sine_wave accuracy 0.3 scale 0.4 } })
Tile(texture { normal { granite 0.8 accuracy 0.001 scale 0.7 } })
Tile(texture { normal { bumps 0.8 no_bump_scale scale 0.1 } })
Tile(texture { normal { checker normal { granite 0.5 scale 0.2 } normal { gradient x 0.6 triangle_wave scale 0.2 } scale 0.4 } })
Tile(texture { normal { average normal_map { [1 ripples 0.8 scale 0.3 translate x] [2 waves 0.9 scale 0.2] [0.5 bumps 1 scale 0.1] } } })
Tile(texture { normal { crackle 0.8 metric 1 offset 0.1 scale 0.3 } })
Tile(texture { normal { facets size 0.6 scale 0.4 } })
Tile(texture { normal { facets coords 0.4 scale 0.3 turbulence 0.2 } })
Tile(texture { normal { brick normal { bumps 0.7 scale 0.06 } normal { granite 0.4 scale 0.2 } brick_size <0.6, 0.3, 0.3> mortar 0.06 } })
