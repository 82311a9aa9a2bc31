// A pigment outside of any object.
// expect error 4:1: expected an object or a directive, found 'pigment'
camera { location <0, 2, -6> look_at 0 }
pigment { rgb 1 }
