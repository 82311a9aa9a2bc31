#pragma once

#include "render/function/function.h"
#include "tests/render/shape_test_support.h"

#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace firstlight::render {

/// A function of three numbers.
class Formula final : public Function {
 public:
  using Value = std::function<double(double, double, double)>;
  explicit Formula(Value value) : Function(3, 1), value_(std::move(value)) {}
  void evaluate(const double* p, double* results, Evaluation&) const override { *results = value_(p[0], p[1], p[2]); }

 private:
  Value value_;
};

inline FunctionPtr formula(Formula::Value value) { return std::make_shared<Formula>(std::move(value)); }

/// The nearest crossing beyond some depth, asked for alone, is that of all.
inline void check_first(const ShapePtr& shape, unsigned seed, int count = 1000) {
  RayRain rain(seed);
  for (int i = 0; i < count; ++i) {
    const Ray ray = rain.next();
    double expected = std::numeric_limits<double>::infinity();
    for (const Crossing& crossing : met(shape, ray)) expected = std::min(expected, crossing.depth);
    for (const double room : {-0.1, 1e-3, 1e9}) {
      std::vector<Crossing> found;
      shape->nearest(ray, 0.0, expected < 1e9 ? expected + room : 1e9, found);
      double first = std::numeric_limits<double>::infinity();
      for (const Crossing& crossing : found) first = std::min(first, crossing.depth);
      if (room > 0.0) {
        ASSERT_EQ(first, expected);
      } else {
        ASSERT_GE(first, expected);
      }
    }
  }
}

/// Crossings lie in the shape's box, and normals have unit length. Returns how many crossings there were.
inline int check_crossings(const ShapePtr& shape, unsigned seed, int count = 2000) {
  RayRain rain(seed);
  const Box3 box = padded(shape->bounds(), 1e-9, 1e-7);
  int crossings = 0;
  for (int i = 0; i < count; ++i) {
    const Ray ray = rain.next();
    for (const Crossing& crossing : met(shape, ray)) {
      ++crossings;
      const Vec3 p = ray.at(crossing.depth);
      EXPECT_TRUE(box.intersects(p)) << p;
      EXPECT_NEAR(shape->normal(p, crossing).length(), 1.0, 1e-9);
    }
  }
  return crossings;
}

}  // namespace firstlight::render
