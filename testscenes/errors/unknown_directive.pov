// A directive that does not exist.
// expect error 4:2: expected a directive after '#', found 'declar'
camera { location <0, 2, -6> look_at 0 }
#declar A = 1;
