// A string that is not closed.
// expect error 4:8: expected '"' to end the string
camera { location <0, 2, -6> look_at 0 }
#debug "never closed
sphere { 0, 1 }
