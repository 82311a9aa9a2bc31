// A mistake inside a macro: the place is in the macro, a note tells who called it.
// expect error 5:31: expected
camera { location <0, 2, -6> look_at 0 }
#macro Ball(R)
  sphere { 0, R pigment { rgb } }
#end
Ball(1)
