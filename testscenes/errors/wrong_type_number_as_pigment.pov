// A number where a pigment must stand.
// expect error 5:25: expected
camera { location <0, 2, -6> look_at 0 }
#declare N = 3;
sphere { 0, 1 pigment { N } }
