// A cone with too few values.
// expect error 4:16: expected
camera { location <0, 2, -6> look_at 0 }
cone { 0, 1, y }
