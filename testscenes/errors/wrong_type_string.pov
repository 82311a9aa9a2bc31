// A string where a vector must stand.
// expect error 4:10: expected
camera { location <0, 2, -6> look_at 0 }
sphere { "a", 1 }
