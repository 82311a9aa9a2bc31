// A #macro without #end.
// expect error 6:1: expected '#end' to close '#macro', found end of file
camera { location <0, 2, -6> look_at 0 }
#macro Ball(R)
  sphere { 0, R }
