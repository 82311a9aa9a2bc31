// The colours of thin films: amount, thickness, turbulence, on tilted surfaces, in highlights and mirrors, wavelengths.
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <0.6, 0.5, 0.4> }
camera { location <0, 0, -6> look_at 0 angle 60 }
light_source { <-10, 20, -30> rgb 1 }
light_source { <20, 5, -10> rgb <0.4, 0.4, 0.3> }
#macro Ball(I, J, T) sphere { 0, 0.72 texture { T } translate <I*1.5 - 2.25, 0.78 - J*1.56, 0> } #end
Ball(0, 0, texture { pigment { rgb 0.7 } finish { irid { 0.4 thickness 0.5 } } })
Ball(1, 0, texture { pigment { rgb 0.7 } finish { irid { 0.3 thickness 1.5 turbulence 0.3 } specular 0.6 } })
Ball(2, 0, texture { pigment { rgb 0.3 } finish { irid { 0.6 thickness 0.8 } reflection 0.6 phong 0.5 } })
Ball(3, 0, texture { pigment { rgb 0.7 } normal { bumps 0.6 scale 0.2 } finish { irid { 0.4 thickness 0.6 } reflection 0.3 } })
Ball(0, 1, texture { pigment { rgb <0.7, 0.3, 0.2> } finish { irid { 0.4 thickness 0.5 turbulence 1 } diffuse 0.4, 0.3 } } texture { pigment { rgbt <1, 1, 1, 0.5> } finish { irid { 0.3 thickness 2 } } })
plane { y, -1.7 pigment { checker rgb 0.3 rgb 0.7 } finish { irid { 0.3 thickness 3 } } }
