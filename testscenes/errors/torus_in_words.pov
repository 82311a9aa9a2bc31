// A shape whose brace is missing.
// expect error 4:7: expected '{'
camera { location <0, 2, -6> look_at 0 }
torus 1, 0.3
