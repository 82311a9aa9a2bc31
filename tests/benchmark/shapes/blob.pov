// How fast many of a kind are traced, see docs/performance.md. A blob of 500 components.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3.2> look_at 0 angle 50 }
light_source { <4, 6, -8> rgb 1 }
#declare R = seed(7);
blob {
  threshold 0.5
  #for (I, 1, 500)
    sphere { vnormalize(<rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>) * (0.6 + 0.4 * rand(R)), 0.22, 1 }
  #end
  pigment { rgb <0.3, 0.7, 0.9> } finish { phong 0.6 }
}
