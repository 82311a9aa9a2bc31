// Interiors that are declared, in a material, and that a union gives to its parts.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Glass = interior { ior 1.5 }
#declare Green_Glass = material { texture { pigment { rgbf <0.7, 1, 0.8, 0.9> } finish { diffuse 0.1 phong 0.7 } } interior { Glass } }
sphere { <-1.6, 0, 0>, 0.7 material { Green_Glass } }
sphere { <0, 0, 0>, 0.7 pigment { rgbt <1, 0.8, 0.6, 0.8> } interior { Glass } }
union { sphere { 0, 0.4 } box { <0.3, -0.3, -0.3>, <0.9, 0.3, 0.3> } pigment { rgbt <0.7, 0.8, 1, 0.8> } interior { Glass ior 1.2 } translate <1.4, 0, 0> }
