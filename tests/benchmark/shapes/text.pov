// How fast many of a kind are traced, see docs/performance.md. Forty lines of text.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <9, -10, -24> look_at <9, -10, 0> angle 60 }
light_source { <-10, 20, -40> rgb 1 }
#for (I, 0, 39)
  text { ttf "timrom.ttf" "The quick brown fox jumps over the lazy dog" 0.3, 0
    pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.3 } translate -I * 0.6 * y }
#end
plane { z, 1 pigment { rgb 0.8 } }
