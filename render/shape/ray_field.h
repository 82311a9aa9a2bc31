#pragma once

#include "render/function/function.h"
#include "render/math/ray_columns.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace firstlight::render {

/// The first result of a function of x, y and z at many points. A single one is asked for alone, which takes less.
inline void evaluate_field(const Function& function, const std::array<const double*, 3>& points, std::size_t count,
                           double* values, Evaluation& evaluation) {
  if (count == 0) return;
  if (count == 1) {
    const std::array<double, 3> point{*points[0], *points[1], *points[2]};
    std::array<double, Function::kMostResults> found;
    function.evaluate(point.data(), found.data(), evaluation);
    *values = found[0];
    return;
  }
  const std::size_t more = function.result_count() - 1;
  const auto others = more == 0 ? nullptr : std::make_unique_for_overwrite<double[]>(more * count);
  std::array<double*, Function::kMostResults> results{values};
  for (std::size_t r = 0; r < more; ++r) results[r + 1] = others.get() + r * count;
  function.evaluate_many(points.data(), results.data(), count, evaluation);
}

/// A function of space along the rays of a block, less a threshold; where a ray is turned, the negative.
class RayFields {
 public:
  RayFields(const Function& function, double threshold, const RayColumns& rays, int noise_generator)
      : function_(function), threshold_(threshold), rays_(rays), noise_generator_(noise_generator) {
    sign_.at.fill(1.0);
  }

  const RayColumns& rays() const { return rays_; }
  double threshold() const { return threshold_; }
  const Column<double>& sign() const { return sign_; }
  void turn(std::size_t ray) { sign_[ray] = -sign_[ray]; }
  /// The function itself at some points.
  void evaluate(const std::array<const double*, 3>& points, std::size_t count, double* values) const {
    Evaluation evaluation{.noise_generator = noise_generator_};
    evaluation.steps_left /= kMostTimes;  // the same for each point, whatever else is asked
    evaluate_field(function_, points, count, values, evaluation);
  }
  /// The values of the rays in `who`, each at a depth of its own.
  void at(std::uint64_t who, const Column<double>& depth, Column<double>& values) const {
    std::array<Column<double>, 3> points;
    Column<double> found;
    std::size_t count = 0;
    for (std::uint64_t bits = who; bits != 0; bits &= bits - 1, ++count) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        points[axis][count] = rays_.origin.of[axis][i] + rays_.direction.of[axis][i] * depth[i];
      }
    }
    evaluate({&points[0][0], &points[1][0], &points[2][0]}, count, found.at.data());
    count = 0;
    for (std::uint64_t bits = who; bits != 0; bits &= bits - 1, ++count) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      values[i] = sign_[i] * (found[count] - threshold_);
    }
  }

 private:
  static constexpr std::uint64_t kMostTimes = 16;

  const Function& function_;
  double threshold_;
  const RayColumns& rays_;
  int noise_generator_;
  Column<double> sign_;
};

}  // namespace firstlight::render
