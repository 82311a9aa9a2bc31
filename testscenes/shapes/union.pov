// A union: its parts keep their own textures or take the one of the union; a union of unions, moved as one.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#declare Lamp = union {
  sphere { 0.9*y, 0.35 pigment { rgb <1, 0.9, 0.3> } }
  union {
    cylinder { -y, 0.6*y, 0.1 }
    cone { -y, 0.5, -0.7*y, 0.1 }
    pigment { rgb <0.5, 0.3, 0.2> }
  }
  torus { 0.3, 0.06 translate 0.55*y }
  pigment { rgb <0.3, 0.7, 0.5> }
}
object { Lamp translate -1.3*x }
object { Lamp scale <1.4, 0.6, 1> rotate -20*z translate <1, -0.4, 0> }
object { Lamp pigment { rgb <0.9, 0.2, 0.6> } scale 0.5 translate <0, -0.5, -1.5> }
