// A light where it cannot be.
// expect error 4:15: light_source
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 light_source { 5, 1 } }
