// An #if without #end.
// expect error 6:1: expected '#end' to close '#if', found end of file
camera { location <0, 2, -6> look_at 0 }
#if (1)
  sphere { 0, 1 }
