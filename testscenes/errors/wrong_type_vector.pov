// A vector where a number must stand.
// expect error 4:13: expected
camera { location <0, 2, -6> look_at 0 }
sphere { 0, <1, 2, 3> }
