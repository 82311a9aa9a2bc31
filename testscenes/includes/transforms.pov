// transforms.inc: turning about an axis, from one direction to another, shearing, and matrices by columns.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#include "transforms.inc"
#declare Mark = union { box { <-0.1, 0, -0.1>, <0.1, 0.7, 0.1> } cone { 0.7*y, 0.2, 1*y, 0 } sphere { 0.25*x, 0.12 } }
object { Mark translate <-2, 0, 0> pigment { rgb 0.7 } }
object { Mark Axis_Rotate_Trans(<1, 1, 0>, 60) translate <-1.2, 0, 0> pigment { rgb <0.9, 0.3, 0.2> } }
object { Mark Rotate_Around_Trans(<0, 0, 50>, 0.9*y) translate <-0.4, 0, 0> pigment { rgb <0.3, 0.7, 0.9> } }
object { Mark Reorient_Trans(y, <1, 1, -0.5>) translate <0.5, 0, 0> pigment { rgb <0.6, 0.9, 0.3> } }
object { Mark Shear_Trans(x, y + 0.4*x, z) translate <1.3, 0, 0> pigment { rgb <0.9, 0.8, 0.3> } }
object { Mark Matrix_Trans(x, 0.6*y, z - 0.3*y, <2, 0.1, 0>) pigment { rgb <0.8, 0.4, 0.9> } }
object { Mark Point_At_Trans(<1, 0.3, -0.6>) translate <0, -0.7, -1.4> pigment { rgb <0.4, 0.9, 0.8> } }
