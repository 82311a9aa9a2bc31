// A #switch without #end.
// expect error 4:1: #switch
camera { location <0, 2, -6> look_at 0 }
#switch (1)
  #case (1)
  sphere { 0, 1 }
