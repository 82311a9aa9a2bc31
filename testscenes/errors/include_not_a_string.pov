// #include of something that is not a name.
// expect error 4:10: expected a string
camera { location <0, 2, -6> look_at 0 }
#include 5
