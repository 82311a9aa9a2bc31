// A table with glass, metal, wood-like stripes and a mirror: many features in one picture.

#include "colors.inc"

global_settings { assumed_gamma 1 max_trace_level 8 }

camera { location <0, 2.6, -7> look_at <0, 0.5, 0> right x*image_width/image_height angle 40 }
background { color rgb <0.32, 0.38, 0.5> }
light_source { <-5, 7, -6>, color White*0.9 }
light_source { <6, 4, -4>, color rgb <0.35, 0.3, 0.25> fade_distance 8 fade_power 2 }

#declare Seed = seed(2024);
#declare Wood = pigment {
  gradient x
  color_map { [0 rgb <0.5, 0.3, 0.15>] [0.4 rgb <0.62, 0.4, 0.2>] [1 rgb <0.42, 0.24, 0.12>] }
  triangle_wave
  scale 0.35
}
#declare Metal = finish { ambient 0.05 diffuse 0.25 specular 0.8 roughness 0.02 metallic reflection { 0.6 metallic } }
#declare Glass = material {
  texture {
    pigment { rgbf <0.92, 1, 0.96, 0.92> }
    finish { ambient 0 diffuse 0.05 specular 0.8 roughness 0.005 reflection { 0.02, 0.9 fresnel } conserve_energy }
  }
  interior { ior 1.5 fade_distance 2 fade_power 1 fade_color <0.6, 0.9, 0.7> }
}

// The table, with planks, and a mirror behind it.
#for (I, -6, 6)
  box { <I*0.6 - 0.29, -0.2, -3>, <I*0.6 + 0.29, 0, 2.4> pigment { Wood translate I*x*3.3 rotate 2*rand(Seed)*y } finish { specular 0.2 reflection 0.06 } }
#end
difference {
  box { <-2.6, 0.01, 2>, <2.6, 2.4, 2.2> pigment { color Gold*0.6 } finish { Metal } }
  box { <-2.4, 0.2, 1.9>, <2.4, 2.2, 2.1> pigment { rgb 0.02 } finish { ambient 0 diffuse 0 reflection 0.9 } }
}

// A goblet of glass, made of shells; a bowl of metal with fruit; dice.
merge {
  difference { sphere { 1.3*y, 0.55 } sphere { 1.3*y, 0.5 } plane { -y, -1.5 } }
  cylinder { 0.08*y, 0.78*y, 0.07 }
  cone { 0.011*y, 0.42, 0.14*y, 0.06 }
  material { Glass }
  translate <-1.5, 0, -0.3>
}
union {
  difference { sphere { 0.8*y, 0.8 } sphere { 0.8*y, 0.74 } plane { -y, -0.8 } }
  torus { 0.77, 0.04 translate 0.8*y }
  pigment { rgb <0.95, 0.75, 0.4> }
  finish { Metal }
  translate <0.6, 0.01, 0.4>
}
#for (I, 0, 8)
  #declare Place = vrotate(<0.42*(I > 0), 0, 0>, 45*I*y);
  sphere {
    <0.6, 0.75 + 0.06*(I = 0)*4, 0.4> + Place, 0.22
    pigment { rgb <0.75 + 0.2*rand(Seed), 0.15 + 0.6*rand(Seed), 0.08> }
    finish { phong 0.5 phong_size 30 }
  }
#end
#macro Die(Place, Turn, Colour)
  difference {
    intersection { box { -0.2, 0.2 } sphere { 0, 0.29 } }
    sphere { -0.23*z, 0.08 pigment { White } }
    union { sphere { <-0.1, 0.23, -0.1>, 0.06 } sphere { <0.1, 0.23, 0.1>, 0.06 } pigment { White } }
    pigment { color Colour }
    finish { specular 0.6 }
    rotate Turn*y
    translate Place + 0.201*y
  }
#end
Die(<-0.3, 0, -1.7>, 25, Firebrick)
Die(<0.35, 0, -2>, -40, NavyBlue)
cone { <1.9, 0, -1.1>, 0.35, <1.9, 1.1, -1.1>, 0 pigment { checker color ForestGreen, color Wheat scale 0.18 } }
sphere { <-2.4, 0.36, 0.7>, 0.35 pigment { rgb 0.1 } finish { reflection { 0.1, 1 falloff 2 } phong 0.9 } }
