// A shape that lacks its radius.
// expect error 4:20: expected
camera { location <0, 2, -6> look_at 0 }
sphere { <0, 0, 0> }
