// A vector that is not closed.
// expect error 4:22: found '}'
camera { location <0, 2, -6> look_at 0 }
sphere { <0, 0, 0, 1 }
