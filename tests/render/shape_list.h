#pragma once

#include "render/math/transform.h"
#include "render/shape/primitives.h"
#include "render/shape/quadric.h"
#include "render/shape/slots.h"
#include "render/shape/superellipsoid.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace firstlight::render {

struct NamedShape {
  std::string name;
  ShapePtr shape;
};

/// Shapes about the origin whose formulas are over lanes, and some whose are not.
inline std::vector<NamedShape> shapes_of_all_kinds() {
  const Transform turned = Transform::scaling(Vec3(1.3, 0.7, 1.0))
                               .then(Transform::rotation(Vec3(20.0, 30.0, 40.0)))
                               .then(Transform::translation(Vec3(0.1, -0.2, 0.3)));
  QuadricParameters paraboloid;
  paraboloid.square = Vec3(1.0, 0.0, 2.0);
  paraboloid.linear = Vec3(0.0, -1.0, 0.0);
  paraboloid.constant = -0.3;
  const Vec3 a(-1.0, -0.8, 0.1), b(1.1, -0.5, -0.2), c(0.1, 1.2, 0.3);
  std::vector<NamedShape> shapes{
      {"plane", make_plane(Vec3(0.2, 1.0, 0.1), 0.3)},
      {"axial plane", make_plane(Vec3(0.0, 1.0, 0.0), -0.5)},
      {"sphere", make_sphere(Vec3(0.2, 0.0, -0.1), 1.1)},
      {"ellipsoid", make_sphere(Vec3(0.2, 0.0, -0.1), 1.1)->placed(turned)},
      {"box", make_box(Vec3(-1.0, -0.5, -0.7), Vec3(0.8, 1.0, 0.5))},
      {"turned box", make_box(Vec3(-1.0, -0.5, -0.7), Vec3(0.8, 1.0, 0.5))->placed(turned)},
      {"cylinder", make_cylinder(Vec3(0.0, -1.0, 0.1), Vec3(0.3, 1.0, 0.0), 0.8, false)},
      {"open cylinder", make_cylinder(Vec3(0.0, -1.0, 0.0), Vec3(0.0, 1.0, 0.0), 0.8, true)->placed(turned)},
      {"cone", make_cone(Vec3(0.0, -1.0, 0.1), 1.2, Vec3(0.3, 1.0, 0.0), 0.4, false)},
      {"open cone", make_cone(Vec3(0.0, -1.0, 0.0), 1.0, Vec3(0.0, 1.0, 0.0), 0.0, true)},
      {"disc", make_disc(Vec3(0.0, 0.1, 0.0), Vec3(0.3, 1.0, 0.2), 1.4, 0.3)},
      {"triangle", make_triangle(a, b, c)},
      {"smooth triangle",
       make_smooth_triangle(a, Vec3(0.1, 0.0, -1.0), b, Vec3(0.0, 0.2, -1.0), c, Vec3(0.0, 0.0, -1.0))},
      {"quadric", make_quadric(paraboloid)},
      {"turned quadric", make_quadric(paraboloid)->placed(turned)},
      {"torus", make_torus(0.9, 0.3)},
      {"superellipsoid", make_superellipsoid(0.3, 0.7)},
  };
  const std::size_t count = shapes.size();
  for (std::size_t i = 0; i < count; ++i) shapes.push_back({"inverse " + shapes[i].name, shapes[i].shape->inverted()});
  return shapes;
}

/// Rays from the points towards places about the origin, which depend on the point alone.
inline RayColumns rays_from(const Columns3<double>& points, std::size_t count) {
  RayColumns rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = points.vector(i);
    const auto scattered = [](double x) { return 2.4 * (x - std::floor(x)) - 1.2; };
    const Vec3 aim(scattered(7.3 * p.x + 0.1), scattered(3.7 * p.y + 0.2), scattered(5.1 * p.z + 0.3));
    rays.origin.set(i, p);
    rays.direction.set(i, unit(aim - p));
  }
  return rays;
}

}  // namespace firstlight::render
