// A #macro without #end.
// expect error 4:1: #macro
camera { location <0, 2, -6> look_at 0 }
#macro Ball(R)
  sphere { 0, R }
