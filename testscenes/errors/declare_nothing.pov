// #declare without a value.
// expect error 4:14: expected a value, found ';'
camera { location <0, 2, -6> look_at 0 }
#declare A = ;
