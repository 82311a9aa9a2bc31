// #error stops the scene with its words.
// expect error 4:1: Nobody renders this.
camera { location <0, 2, -6> look_at 0 }
#error "Nobody renders this."
