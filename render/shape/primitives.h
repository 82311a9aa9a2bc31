#pragma once

#include "render/shape/shape.h"

namespace firstlight::render {

// Makers of the primitives, each in untransformed space. Arguments are as in the scene language; what POV-Ray repairs
// (exchanged box corners, say) is repaired here, what it refuses is the parser's to refuse.

ShapePtr make_sphere(const Vec3& center, double radius);
ShapePtr make_box(const Vec3& corner1, const Vec3& corner2);
/// Points p with normal . p = distance * |normal| are on it; inside is the side away from the normal.
ShapePtr make_plane(const Vec3& normal, double distance);
ShapePtr make_cylinder(const Vec3& base, const Vec3& cap, double radius, bool open);
ShapePtr make_cone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius, bool open);
/// Around the y axis; `major` to the middle of the tube, `minor` of the tube itself.
ShapePtr make_torus(double major, double minor);
ShapePtr make_disc(const Vec3& center, const Vec3& normal, double radius, double hole_radius);
/// A degenerate triangle (no area) gives nullptr; POV-Ray drops it with a warning.
ShapePtr make_triangle(const Vec3& a, const Vec3& b, const Vec3& c);
ShapePtr make_smooth_triangle(const Vec3& a, const Vec3& normal_a, const Vec3& b, const Vec3& normal_b, const Vec3& c,
                              const Vec3& normal_c);

}  // namespace firstlight::render
