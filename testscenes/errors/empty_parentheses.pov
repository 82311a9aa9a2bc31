// An expression that is empty.
// expect error 4:15: expected
camera { location <0, 2, -6> look_at 0 }
#declare A = ();
