// The complement of a union's complement is a merge: what is inside it is not seen through its clear surface.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at 0 angle 45 }
background { rgb <0.2, 0.5, 0.2> }
light_source { <4, 8, -6>, 1 }
#default { finish { ambient 0.3 diffuse 0.6 } }
#declare Pair = union {
  sphere { <-0.4, 0, 0>, 0.8 pigment { rgbt <1, 0.2, 0.2, 0.6> } }
  sphere { <0.4, 0, 0>, 0.8 pigment { rgbt <0.2, 0.2, 1, 0.6> } }
}
object { Pair translate <-2.2, 1, 0> }
object { Pair inverse inverse translate <0, 1, 0> }
merge { object { Pair } translate <2.2, 1, 0> }
// Subtracted, and the whole turned inside out.
difference { box { -3, 3 } object { Pair } inverse translate <-1.2, -1, 0> }
intersection { object { Pair } box { -1.5, 1.5 pigment { rgbt 0.8 } } inverse inverse translate <1.4, -1, 0> }
