// An #else without #if.
// expect error 4:2: '#else' without '#if'
camera { location <0, 2, -6> look_at 0 }
#else
