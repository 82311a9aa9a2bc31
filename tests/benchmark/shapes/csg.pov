// How fast many of a kind are traced, see docs/performance.md. One hundred plates, of each of which a hundred cylinders are cut: 10,000 parts in differences.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 9, -14> look_at <0, -0.5, 0> angle 50 }
light_source { <-6, 14, -10> rgb 1 }
#for (I, -5, 4)
  #for (J, -5, 4)
    difference {
      box { <0.02, -0.2, 0.02>, <0.98, 0.2, 0.98> }
      #for (A, 0, 9)
        #for (B, 0, 9)
          cylinder { <0.05 + A * 0.1, -0.3, 0.05 + B * 0.1>, <0.05 + A * 0.1, 0.3, 0.05 + B * 0.1>, 0.035 }
        #end
      #end
      pigment { rgb <0.6 + 0.08 * I, 0.7, 0.6 - 0.08 * J> }
      translate <I, 0.3 * sin(I) * cos(J), J>
    }
  #end
#end
plane { y, -1.5 pigment { checker rgb 0.8 rgb 0.4 } }
