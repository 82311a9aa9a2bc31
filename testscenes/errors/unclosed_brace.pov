// A brace that is never closed, noticed at the word that cannot stand inside.
// expect error 5:1: expected '}' to close 'sphere', found 'box'
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1
box { 0, 1 }
