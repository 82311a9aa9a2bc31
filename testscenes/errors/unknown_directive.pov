// A directive that does not exist.
// expect error 4:1: expected a directive
camera { location <0, 2, -6> look_at 0 }
#declar A = 1;
