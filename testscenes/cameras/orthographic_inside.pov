// The rays begin in different matter: in glass, in a combination, or in air.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
light_source { <-4, 6, -5>, rgb 1 }
camera { orthographic location <0, 0.4, 0> direction z right 6*x up 4.5*y }
plane { y, -1.5 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }
sphere { <-1.2, 0, 0>, 1.3 pigment { rgbt <0.9, 1, 0.9, 0.85> } finish { ambient 0.15 } interior { ior 1.4 fade_distance 1 fade_power 2 } }
box { <0.6, -1, -1>, <2.2, 1, 3> pigment { rgbt <1, 0.9, 0.8, 0.8> } interior { ior 1.2 } }
intersection {
  box { <-0.5, 1.1, -2>, <1.5, 2, 2> } sphere { <0.5, 1.4, 0>, 1.2 }
  pigment { rgbt <0.8, 0.9, 1, 0.7> } interior { ior 1.6 }
}
sphere { <0, 0, 3>, 0.8 pigment { rgb <0.9, 0.3, 0.2> } }
box { <-3, -1, 2.5>, <-2, 1, 3> pigment { rgb <0.3, 0.7, 0.9> } }
