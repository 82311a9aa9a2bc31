#pragma once

#include "render/math/color.h"
#include "render/math/vec.h"

#include <random>

namespace firstlight::render {

/// Random numbers that are the same in every run.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3 point(double reach) {
    const double x = between(-reach, reach);
    const double y = between(-reach, reach);
    return {x, y, between(-reach, reach)};
  }
  Vec3 direction() { return point(1.0).normalized(); }
  Rgb color() {
    const float r = static_cast<float>(between(0.0, 1.0));
    const float g = static_cast<float>(between(0.0, 1.0));
    return {r, g, static_cast<float>(between(0.0, 1.0))};
  }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

 private:
  std::mt19937 random_;
};

}  // namespace firstlight::render
