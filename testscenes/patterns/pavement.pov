// Pavements of triangles, squares and hexagons that are joined to tiles, with sharp, blunt and round corners of all kinds.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -100> look_at 0 right x*4/3 angle 9.4 }
light_source { <-50, 80, -100> rgb 1 }
#default { finish { ambient 1 diffuse 0 } }
#declare Map = color_map { [0 rgb <0.9, 0.7, 0.4>] [0.8 rgb <0.5, 0.15, 0.05>] [0.95 rgb <0.3, 0.1, 0.1>] [1 rgb 0.9] }
#declare N = 0;
#macro Tile(Sides, Tiles, Pattern, Exterior, Interior, Form)
  box {
    <-0.96, -0.96, 0>, <0.96, 0.96, 0.1>
    pigment {
      pavement number_of_sides Sides number_of_tiles Tiles pattern Pattern exterior Exterior interior Interior form Form
      color_map { Map } rotate -90*x rotate (3 + N)*z scale 0.29 translate <1.23, 0.77, 0>
    }
    translate <2*mod(N, 8) - 7, 5 - 2*floor(N/8), 0>
  }
  #declare N = N + 1;
#end
Tile(3, 1, 1, 2, 0, 0) Tile(3, 2, 1, 0, 0, 2) Tile(3, 3, 1, 1, 1, 1) Tile(3, 4, 2, 0, 1, 0) Tile(3, 4, 3, 2, 0, 2)
Tile(3, 5, 2, 0, 2, 1) Tile(3, 5, 4, 1, 0, 2) Tile(3, 6, 3, 0, 2, 2) Tile(3, 6, 4, 1, 1, 0) Tile(3, 6, 6, 2, 2, 1)
Tile(3, 6, 7, 0, 0, 2) Tile(3, 6, 8, 1, 2, 1) Tile(3, 6, 9, 2, 1, 0) Tile(3, 6, 11, 0, 0, 1) Tile(3, 6, 12, 0, 1, 2)
Tile(4, 1, 1, 1, 0, 0) Tile(4, 2, 1, 2, 0, 0) Tile(4, 3, 2, 0, 0, 2) Tile(4, 4, 2, 0, 1, 1) Tile(4, 4, 3, 1, 2, 3)
Tile(4, 4, 4, 2, 0, 0) Tile(4, 4, 5, 0, 2, 2) Tile(4, 5, 3, 1, 1, 3) Tile(4, 5, 5, 2, 2, 0) Tile(4, 5, 8, 0, 0, 1)
Tile(4, 5, 10, 1, 2, 2) Tile(4, 5, 12, 2, 1, 3) Tile(4, 6, 4, 0, 0, 0) Tile(4, 6, 11, 0, 2, 1) Tile(4, 6, 18, 2, 0, 2)
Tile(4, 6, 25, 1, 1, 1) Tile(4, 6, 31, 2, 2, 3) Tile(4, 6, 34, 0, 1, 2) Tile(6, 1, 1, 1, 0, 0) Tile(6, 2, 1, 2, 0, 1)
Tile(6, 3, 1, 0, 0, 2) Tile(6, 3, 2, 0, 1, 0) Tile(6, 3, 3, 1, 2, 1) Tile(6, 4, 3, 2, 1, 2) Tile(6, 4, 5, 0, 2, 0)
Tile(6, 4, 7, 1, 0, 2) Tile(6, 5, 2, 0, 1, 1) Tile(6, 5, 5, 0, 2, 2) Tile(6, 5, 8, 2, 0, 0) Tile(6, 5, 14, 1, 1, 2)
Tile(6, 5, 17, 0, 0, 1) Tile(6, 5, 22, 2, 2, 0)
box {
  <-0.96, -0.96, 0>, <0.96, 0.96, 0.1> pigment { rgb 0.9 } finish { ambient 0 diffuse 0.8 }
  normal { pavement 0.7 number_of_sides 6 number_of_tiles 3 pattern 2 rotate -90*x scale 0.3 }
  translate <7, -5, 0>
}
