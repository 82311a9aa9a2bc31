// A byte that the language does not know.
// expect error 4:17: expected
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 } @
