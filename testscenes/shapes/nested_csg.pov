// Constructive geometry nested five deep, with shared surfaces between the parts.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Arch = difference { box { <-0.5, 0, -0.3>, <0.5, 1, 0.3> } cylinder { -z, z, 0.35 } }
#declare Wall = union {
  object { Arch translate -x }
  object { Arch }
  object { Arch translate x }
  box { <-1.5, 1, -0.4>, <1.5, 1.2, 0.4> }
}
difference {
  union {
    object { Wall }
    object { Wall rotate 90*y translate <1.5, 0, 1.5> }
  }
  merge { sphere { <1.5, 1.2, 0>, 0.5 } sphere { <1.1, 1.3, -0.3>, 0.4 } }
  intersection { plane { x, -1.1 } plane { z, -0.1 } plane { -y, -0.9 } }
  pigment { rgb <0.85, 0.75, 0.6> }
  translate -1*y
}
