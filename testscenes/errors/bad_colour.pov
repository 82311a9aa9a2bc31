// A colour without its numbers.
// expect error 4:29: expected
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 pigment { rgb } }
