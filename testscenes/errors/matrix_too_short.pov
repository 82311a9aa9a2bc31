// A matrix with too few numbers.
// expect error 4:39: expected
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0> }
