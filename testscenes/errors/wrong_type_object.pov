// An object where a number must stand.
// expect error 5:13: expected
camera { location <0, 2, -6> look_at 0 }
#declare Ball = sphere { 0, 1 }
sphere { 0, Ball }
