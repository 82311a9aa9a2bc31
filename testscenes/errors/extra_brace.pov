// A brace that closes nothing.
// expect error 4:17: found '}'
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 } }
