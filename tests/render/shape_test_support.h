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

/// What must hold for any closed solid: crossings lie in its box, inside changes at each of them, normals point out of
/// it, the complement is met at the same depths with the normal turned around.
inline void check_closed_solid(const ShapePtr& shape, unsigned seed, bool complement = false) {
  RayRain rain(seed);
  const ShapePtr other = shape->inverted();
  const Box3 box = padded(shape->bounds(), 1e-9);
  int met_count = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray ray = rain.next();
    for (const Crossing& c : met(shape, ray)) {
      ++met_count;
      const Vec3 p = ray.at(c.depth);
      ASSERT_TRUE(box.intersects(p)) << p;
      const Vec3 n = shape->normal(p, c);
      ASSERT_NEAR(n.length(), 1.0, 1e-12);
      ASSERT_EQ(shape->inside(p - n * 1e-5), !complement || shape->inside(p + n * 1e-5) != true) << p;
      if (std::abs(n.dot(ray.direction)) < 1e-2) continue;
      const double step = n.dot(ray.direction) > 0.0 ? -1e-5 : 1e-5;
      ASSERT_TRUE(shape->inside(ray.at(c.depth + step)) || complement) << p;
    }
    ASSERT_EQ(depths(shape, ray), depths(other, ray));
  }
  ASSERT_GT(met_count, 200);
}

}  // namespace firstlight::render
