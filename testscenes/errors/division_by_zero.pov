// A division by zero.
// expect error 5:15: zero
camera { location <0, 2, -6> look_at 0 }
#declare A = 0;
#declare B = 1/A;
