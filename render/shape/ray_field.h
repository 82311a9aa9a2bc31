#pragma once

#include "render/function/function.h"
#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <span>

namespace firstlight::render {

/// The first result of a function of x, y and z at many points, at most kFieldPoints.
constexpr std::size_t kFieldPoints = 32;
using FieldColumn = std::array<double, kFieldPoints>;
inline void evaluate_field(const Function& function, const std::array<FieldColumn, 3>& points, std::size_t count,
                           FieldColumn& values, Evaluation& evaluation) {
  std::array<FieldColumn, Function::kMostResults - 1> others;
  std::array<double*, Function::kMostResults> results{values.data()};
  for (std::size_t r = 1; r < results.size(); ++r) results[r] = others[r - 1].data();
  const std::array<const double*, 3> arguments{points[0].data(), points[1].data(), points[2].data()};
  function.evaluate_many(arguments.data(), results.data(), count, evaluation);
}

/// A function of space along a ray, less a threshold; turned, it is the negative.
class RayField {
 public:
  RayField(const Function& function, double threshold, const Ray& ray, Evaluation& evaluation)
      : function_(function), threshold_(threshold), ray_(ray), evaluation_(evaluation) {}

  void turn() { sign_ = -sign_; }
  double at(double depth) const {
    const Vec3 point = ray_.at(depth);
    const std::array<double, 3> arguments{point.x, point.y, point.z};
    std::array<double, Function::kMostResults> results;
    function_.evaluate(arguments.data(), results.data(), evaluation_);
    return sign_ * (results[0] - threshold_);
  }
  /// The same at some depths, at most kFieldPoints: cheaper than one by one.
  void at(std::span<const double> depths, FieldColumn& values) const {
    if (depths.size() == 1) {
      values[0] = at(depths[0]);
      return;
    }
    std::array<FieldColumn, 3> points;
    for (int axis = 0; axis < 3; ++axis) {
      const double o = ray_.origin[axis];
      const double d = ray_.direction[axis];
      FieldColumn& column = points[static_cast<std::size_t>(axis)];
      for (std::size_t i = 0; i < depths.size(); ++i) column[i] = o + d * depths[i];
    }
    evaluate_field(function_, points, depths.size(), values, evaluation_);
    for (std::size_t i = 0; i < depths.size(); ++i) values[i] = sign_ * (values[i] - threshold_);
  }

 private:
  const Function& function_;
  double threshold_;
  const Ray& ray_;
  Evaluation& evaluation_;
  double sign_ = 1.0;
};

}  // namespace firstlight::render
