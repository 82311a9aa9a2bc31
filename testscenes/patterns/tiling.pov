// All 27 tilings, 25 to 27 of which repeat nowhere, and one as a normal.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -100> look_at 0 right x*7/4 angle 8 }
light_source { <-50, 80, -100> rgb 1 }
#default { finish { ambient 1 diffuse 0 } }
#declare Map = color_map {
  [0 rgb <0.1, 0, 0.3>] [0.2 rgb <0.2, 0.3, 0.8>] [0.25 rgb <0.9, 0.6, 0.2>] [0.4 rgb <0.4, 0.1, 0>] [0.55 rgb <0.1, 0.6, 0.3>]
  [0.7 rgb <0.7, 0.9, 0.5>] [0.75 rgb <0.8, 0.2, 0.5>] [0.9 rgb <0.9, 0.9, 0.3>] [1 rgb 1]
}
#declare N = 0;
#while (N < 28)
  box {
    <-0.96, -0.96, 0>, <0.96, 0.96, 0.1>
    #if (N < 27)
      pigment { tiling N + 1 color_map { Map } rotate -90*x rotate 7*z scale 0.31 translate <0.123, 0.377, 0> }
    #else
      pigment { rgb 0.9 }
      normal { tiling 24 0.6 rotate -90*x scale 0.3 }
      finish { ambient 0 diffuse 0.8 }
    #end
    translate <2*mod(N, 7) - 6, 3 - 2*floor(N/7), 0>
  }
  #declare N = N + 1;
#end
