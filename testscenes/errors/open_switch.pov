// A #switch without #end.
// expect error 7:1: expected '#end' to close '#switch', found end of file
camera { location <0, 2, -6> look_at 0 }
#switch (1)
  #case (1)
  sphere { 0, 1 }
