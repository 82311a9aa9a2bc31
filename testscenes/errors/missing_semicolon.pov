// A number that is declared without a semicolon.
// expect error 4:15: expected ';'
camera { location <0, 2, -6> look_at 0 }
#declare A = 1
sphere { 0, A }
