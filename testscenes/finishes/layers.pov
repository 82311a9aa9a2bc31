// Layers of textures: clear and half clear ones, with their own finishes, normals and mirrors, maps of layers, and turned as a whole.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 right x*4/3 angle 45 }
light_source { <-4, 6, -6> rgb 1 }
plane { y, -1 texture { pigment { checker rgb 0.8, rgb 0.2 } } texture { pigment { bozo color_map { [0 rgbt <1, 0, 0, 0.7>] [0.6 rgbt 1] } } finish { reflection 0.2 } } }
#declare Base = texture { pigment { wood turbulence 0.1 scale 0.2 } finish { phong 0.5 } }
#declare Glaze = texture { pigment { granite color_map { [0 rgbf <1, 0.9, 0.5, 0.9>] [0.5 rgbt <0.2, 0.5, 0.9, 0.4>] [1 rgbft <0.2, 0.8, 0.2, 0.3, 0.5>] } scale 0.7 } finish { specular 0.6 reflection 0.1 } }
#declare Dents = texture { pigment { rgbt <1, 1, 1, 0.8> } normal { bumps 0.9 scale 0.1 } finish { phong 1 phong_size 60 reflection { 0.3 metallic } } }
#declare All = texture { Base } texture { Glaze } texture { Dents scale 2 }
sphere { <-2.1, 0, 0>, 0.9 texture { Base } texture { Glaze } }
sphere { <0, 0, 0>, 0.9 texture { All rotate 40*z scale 0.5 } }
sphere { <2.1, 0, 0>, 0.9 texture { All translate 3 } finish { ambient 0.2 } }
box { <-2.4, -1, -2>, <-1.4, -0.2, -1.2> texture { gradient x texture_map { [0.3 All] [0.6 Glaze] } scale 0.5 } }
sphere { <-0.2, -0.5, -1.8>, 0.5 texture { Glaze } texture { Dents } texture { pigment { radial color_map { [0.5 rgbt 1] [0.5 rgb <0.3, 0.1, 0.6>] } frequency 6 } } interior { ior 1.3 } }
sphere { <1.4, -0.5, -1.8>, 0.5 texture { checker texture { All } texture { Base } scale 0.3 } }
