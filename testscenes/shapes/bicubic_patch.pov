// Bezier patches: both types, steps and flatness, their own coordinates, moved, both sides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -11> look_at <0, 0.2, 0> angle 42 }
light_source { <-5, 9, -8> rgb 1 }
light_source { <8, 4, -9> rgb 0.4 }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.6 } }

#macro Patch(Type, Steps, Flat)
  bicubic_patch {
    type Type flatness Flat u_steps Steps v_steps Steps
    Points()
#end
#macro Points()
  <-1.5, 0, -1.5>, <-0.5, 0.8, -1.5>, <0.5, -0.8, -1.5>, <1.5, 0, -1.5>,
  <-1.5, 0.8, -0.5>, <-0.5, 1.5, -0.5>, <0.5, 0, -0.5>, <1.5, -0.8, -0.5>,
  <-1.5, -0.4, 0.5>, <-0.5, 0, 0.5>, <0.5, 1.2, 0.5>, <1.5, 0.6, 0.5>,
  <-1.5, 0, 1.5>, <-0.5, 0.6, 1.5>, <0.5, -0.6, 1.5>, <1.5, 0, 1.5>
#end
Patch(0, 3, 0) pigment { rgb <1, 0.8, 0.3> } finish { phong 0.6 } scale 0.8 rotate <-30, 20, 0> translate <-3.2, 0, 0.6> }
Patch(1, 4, 0.01) pigment { rgb <0.4, 0.7, 0.9> } interior_texture { pigment { rgb <0.9, 0.3, 0.4> } } scale 0.8 rotate <-110, 0, 20> translate <-0.2, 0.3, 0.6> }
bicubic_patch { type 1 u_steps 3 v_steps 2 uv_vectors <0, 0>, <2, 0>, <2, 1>, <0, 1> Points()
  uv_mapping pigment { checker rgb <0.2, 0.3, 0.7> rgb <1, 0.9, 0.6> scale 0.125 } scale 0.8 rotate <-40, -20, 0> translate <3, 0, 0.6> }
// Bent by few steps, and by flatness alone.
Patch(1, 1, 0) pigment { rgb <0.8, 0.3, 0.3> } scale 0.6 rotate <-40, 0, 0> translate <-2.2, -0.4, -2.8> }
Patch(0, 5, 0.3) pigment { rgb <0.3, 0.7, 0.3> } scale 0.6 rotate <-40, 30, 0> translate <0.2, -0.4, -2.8> }
union {
  Patch(1, 3, 0.02) pigment { rgbf <0.8, 0.7, 1, 0.6> } }
  sphere { <0, 0.9, 0>, 0.3 pigment { rgb 0.9 } }
  scale 0.6 rotate <-40, -30, 0> translate <2.6, -0.4, -2.8>
}
