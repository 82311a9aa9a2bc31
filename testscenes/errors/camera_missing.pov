// A scene without a camera.
// expect error 4:1: expected a camera
sphere { 0, 1 }
