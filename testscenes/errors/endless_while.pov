// A loop that never ends: the program stops it in good time.
// expect error 5:2: without end
camera { location <0, 2, -6> look_at 0 }
#while (1)
#end
