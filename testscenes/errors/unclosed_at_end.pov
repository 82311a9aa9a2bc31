// A brace that is never closed, noticed at the end of the file.
// expect error 7:1: expected '}' to close 'union'
camera { location <0, 2, -6> look_at 0 }
union {
  sphere { 0, 1 }
  box { 0, 1 }
