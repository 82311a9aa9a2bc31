// shapes.inc: its shapes of constructive geometry and planes, and its macros for rounded and wire boxes, cylinders and cones.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.45, 0.7> }
camera { location <0, 2, -6> look_at <0, 0.3, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.25, 0.3, 0.35> } }

#include "shapes.inc"
object { Cube scale 0.3 rotate 30*y translate <-2, 0.9, 0> pigment { rgb <0.9, 0.3, 0.2> } }
object { Sphere scale 0.35 translate <-1.1, 0.9, 0> pigment { rgb <0.3, 0.7, 0.9> } }
object { Disk_Y scale <0.35, 0.2, 0.35> translate <-0.2, 0.9, 0> pigment { rgb <0.6, 0.9, 0.3> } }
object { Disk_Z scale <0.3, 0.3, 0.2> rotate 30*y translate <0.7, 0.9, 0> pigment { rgb <0.9, 0.8, 0.3> } }
object { Cone_Y scale 0.35 translate <1.5, 0.9, 0> pigment { rgb <0.8, 0.4, 0.9> } }
object { Round_Box(<-0.4, -0.3, -0.3>, <0.4, 0.3, 0.3>, 0.1, false) rotate 25*y translate <-1.8, -0.4, 0> pigment { rgb <0.9, 0.5, 0.2> } finish { phong 0.5 } }
object { Round_Box_Merge(<-0.3, -0.3, -0.3>, <0.3, 0.3, 0.3>, 0.15) translate <-0.7, -0.4, 0> pigment { rgbt <0.5, 0.9, 0.8, 0.5> } }
object { Round_Cylinder(-0.4*y, 0.4*y, 0.3, 0.1, false) translate <0.3, -0.4, 0> pigment { rgb <0.4, 0.5, 0.9> } }
object { Round_Cone(-0.4*y, 0.35, 0.4*y, 0.15, 0.08, false) translate <1.2, -0.4, 0> pigment { rgb <0.9, 0.4, 0.5> } }
object { Wire_Box_Union(<-0.25, -0.3, -0.25>, <0.25, 0.3, 0.25>, 0.08) rotate 20*y translate <1.9, -0.6, -0.2> pigment { rgb <0.7, 0.9, 0.6> } }
object { Spheroid(0, <0.4, 0.2, 0.3>) translate <0, -0.8, -1.6> pigment { rgb <0.9, 0.9, 0.5> } }
object { Wire_Box(<-0.3, -0.3, -0.3>, <0.3, 0.3, 0.3>, 0.05, false) rotate 30*y translate <1.2, -0.65, -1.6> pigment { rgb <0.9, 0.7, 0.4> } }
object { Plane_XZ translate -5*y pigment { rgb 0.3 } }
