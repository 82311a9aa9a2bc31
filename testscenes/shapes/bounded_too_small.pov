// A ball is seen where rays meet the box of what bounds it, if that is smaller than its own.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,4,-6> look_at 0 angle 40 right x*4/3 }
light_source { <-4,6,-5> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
sphere { 0, 1 pigment { rgb x } bounded_by { box { -0.5, 0.5 } } }
