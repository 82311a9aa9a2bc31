// A #while without #end.
// expect error 7:1: expected '#end' to close '#while', found end of file
camera { location <0, 2, -6> look_at 0 }
#declare I = 0;
#while (I < 3)
  #declare I = I + 1;
