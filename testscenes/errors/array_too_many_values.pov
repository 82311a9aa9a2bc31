// More values than an array holds.
// expect error 4:31: expected '}'
camera { location <0, 2, -6> look_at 0 }
#declare A = array[2] { 1, 2, 3 };
