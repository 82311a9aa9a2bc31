// An #end that ends nothing.
// expect error 5:2: '#end' without '#if'
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 }
#end
