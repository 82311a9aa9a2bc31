// A #while without #end.
// expect error 5:1: #while
camera { location <0, 2, -6> look_at 0 }
#declare I = 0;
#while (I < 3)
  #declare I = I + 1;
