// A macro that calls itself without end.
// expect error 5:3: nested too deeply
camera { location <0, 2, -6> look_at 0 }
#macro A()
  A()
#end
A()
