// A comment that is not closed.
// expect error 5:1: expected '*/' to close the comment
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 }
/* never closed
box { 0, 1 }
