// An index outside of an array.
// expect error 5:16: 3
camera { location <0, 2, -6> look_at 0 }
#declare A = array[3] { 1, 2, 3 };
#declare B = A[3];
