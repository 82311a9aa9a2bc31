#pragma once

#include "render/shape/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace firstlight::render {

inline Ray ray_to(const Vec3& from, const Vec3& to) { return Ray{from, (to - from).normalized()}; }

inline std::vector<Crossing> met(const ShapePtr& shape, const Ray& ray) {
  std::vector<Crossing> out;
  shape->crossings(ray, out);
  return out;
}

inline std::vector<double> depths(const ShapePtr& shape, const Ray& ray) {
  std::vector<double> out;
  for (const Crossing& c : met(shape, ray)) out.push_back(c.depth);
  std::sort(out.begin(), out.end());
  return out;
}

inline void expect_depths(const ShapePtr& shape, const Ray& ray, const std::vector<double>& expected,
                          double tolerance = 1e-9) {
  const std::vector<double> found = depths(shape, ray);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance);
}

inline void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-9) {
  EXPECT_LE((a - b).length(), tolerance) << a << " and " << b;
}

inline void expect_normal(const ShapePtr& shape, const Ray& ray, std::size_t nth, const Vec3& expected) {
  std::vector<Crossing> all = met(shape, ray);
  ASSERT_GT(all.size(), nth);
  std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.depth < b.depth; });
  expect_near(shape->normal(ray.at(all[nth].depth), all[nth]), expected);
}

/// Rays from around a shape towards it.
class RayRain {
 public:
  explicit RayRain(unsigned seed, double far = 10.0, double near = 2.0) : random_(seed), far_(far), near_(near) {}
  Ray next() { return ray_to(point(far_), point(near_)); }
  Vec3 point(double reach) {
    std::uniform_real_distribution<double> between(-reach, reach);
    const double x = between(random_);
    const double y = between(random_);
    return Vec3(x, y, between(random_));
  }

 private:
  std::mt19937 random_;
  double far_;
  double near_;
};

/// Checks what must hold for any closed solid: crossings lie in its box, it is inside behind them and outside before,
/// as its unit normal points; the complement is met at the same depths, with normal and inside turned around.
inline void check_closed_solid(const ShapePtr& shape, unsigned seed) {
  RayRain rain(seed);
  const ShapePtr complement = shape->inverted();
  const Box3 box = padded(shape->bounds(), 1e-9, 1e-30);
  int count = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray ray = rain.next();
    const std::vector<Crossing> all = met(shape, ray);
    const std::vector<Crossing> same = met(complement, ray);
    ASSERT_EQ(all.size(), same.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      ++count;
      ASSERT_EQ(all[k].depth, same[k].depth);
      const Vec3 p = ray.at(all[k].depth);
      const Vec3 n = shape->normal(p, all[k]);
      ASSERT_TRUE(box.intersects(p)) << p;
      ASSERT_NEAR(n.length(), 1.0, 1e-12);
      ASSERT_EQ(complement->normal(p, same[k]), -n);
      for (const double side : {-1e-5, 1e-5}) {
        ASSERT_EQ(shape->inside(p + n * side), side < 0.0) << p;
        ASSERT_EQ(complement->inside(p + n * side), side > 0.0) << p;
      }
    }
  }
  ASSERT_GT(count, 200);
}

/// Placing a shape is the same as taking the ray back.
inline void check_placement(const ShapePtr& shape, const Transform& transform, unsigned seed) {
  RayRain rain(seed);
  const ShapePtr moved = shape->placed(transform);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = rain.next();
    const Ray world{transform.point(ray.origin), transform.direction(ray.direction).normalized()};
    const double stretch = transform.direction(ray.direction).length();
    const std::vector<double> before = depths(shape, ray);
    const std::vector<double> after = depths(moved, world);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t k = 0; k < before.size(); ++k) ASSERT_NEAR(before[k] * stretch, after[k], 1e-6);
    const Vec3 p = rain.point(2.0);
    ASSERT_EQ(shape->inside(p), moved->inside(transform.point(p)));
  }
}

inline Transform uneven_placement() {
  return Transform::scaling(Vec3(1.5, 0.7, 2.0))
      .then(Transform::rotation(Vec3(20, 130, 250)))
      .then(Transform::translation(Vec3(0.5, -1, 2)));
}

}  // namespace firstlight::render
