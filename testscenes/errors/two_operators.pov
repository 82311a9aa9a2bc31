// An operator without its second value.
// expect error 4:18: expected
camera { location <0, 2, -6> look_at 0 }
#declare A = 3 * * 4;
