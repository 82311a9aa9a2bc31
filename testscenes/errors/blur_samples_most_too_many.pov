// The same as the larger of two numbers.
// expect error 4:47: 'blur_samples' must be at most 65536
sphere { 0, 1 }
camera { location -5*z aperture 1 blur_samples 10, 100000 }
