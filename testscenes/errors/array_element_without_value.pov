// An element of an array that has no value yet.
// expect error 5:13: no value
camera { location <0, 2, -6> look_at 0 }
#declare A = array[3];
sphere { 0, A[1] }
