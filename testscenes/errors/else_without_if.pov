// An #else without #if.
// expect error 4:1: #else
camera { location <0, 2, -6> look_at 0 }
#else
