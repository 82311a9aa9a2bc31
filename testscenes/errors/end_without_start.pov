// An #end that ends nothing.
// expect error 5:1: #end
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 }
#end
