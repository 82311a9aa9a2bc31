// A macro that is called with too few values.
// expect error 5:7: expected
camera { location <0, 2, -6> look_at 0 }
#macro Ball(P, R) sphere { P, R } #end
Ball(0)
