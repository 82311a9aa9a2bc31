// How fast many of a kind are traced, see docs/performance.md. Prisms of linear, quadratic, cubic and Bezier splines, straight and conic.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 8, -11> look_at <0, 0, 0> angle 50 }
light_source { <-6, 14, -10> rgb 1 }
#declare Star = prism { linear_sweep linear_spline 0, 1, 11
  #for (K, 0, 10) #declare A = K * pi / 5; #declare D = 0.3 + 0.3 * mod(K, 2); <D * cos(A), D * sin(A)> #end }
#declare Drop = prism { linear_sweep cubic_spline 0, 1, 8 <0.5, 0>, <0.6, 0.2>, <0, 0.6>, <-0.5, 0.2>, <-0.4, -0.4>, <0.2, -0.5>, <0.6, 0.2>, <0, 0.6> }
#declare Cone = prism { conic_sweep linear_spline 0, 1, 5 <-0.6, -0.6>, <0.6, -0.6>, <0.6, 0.6>, <-0.6, 0.6>, <-0.6, -0.6> }
#for (I, -4, 4)
  #for (J, -3, 3)
    object {
      #switch (mod(I + J + 30, 3)) #case (0) Star #break #case (1) Drop #break #else Cone #end
      pigment { rgb <0.7, 0.5 + 0.1 * J, 0.6 + 0.08 * I> } finish { phong 0.4 } translate <I * 1.4, 0, J * 1.4> }
  #end
#end
plane { y, 0 pigment { rgb 0.7 } }
