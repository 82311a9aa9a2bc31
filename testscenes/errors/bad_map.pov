// An entry of a map without its colour.
// expect error 4:50: expected
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 pigment { gradient x color_map { [0] [1 rgb 1] } } }
