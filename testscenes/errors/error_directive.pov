// #error stops the scene with its words.
// expect error 4:2: stopped by '#error': Nobody renders this.
camera { location <0, 2, -6> look_at 0 }
#error "Nobody renders this."
