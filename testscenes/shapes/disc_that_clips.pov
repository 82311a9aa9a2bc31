// A disc is the half space behind it, but POV-Ray asks the disc's flat box first: nearly nothing is left of the ball.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2,3,-6> look_at 0 angle 45 right x*4/3 }
light_source { <4,6,-3> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
sphere { 0, 1 clipped_by { disc { 0, y, 0.5 } } pigment { rgb z } }
