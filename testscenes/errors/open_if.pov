// An #if without #end.
// expect error 4:1: #if
camera { location <0, 2, -6> look_at 0 }
#if (1)
  sphere { 0, 1 }
