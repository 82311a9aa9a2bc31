// A macro that is called with too many values.
// expect error 5:12: expected ')' to close the arguments of 'Ball', found number 2
camera { location <0, 2, -6> look_at 0 }
#macro Ball(P, R) sphere { P, R } #end
Ball(0, 1, 2)
