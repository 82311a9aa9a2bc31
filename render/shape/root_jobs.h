#pragma once

#include "render/math/polynomial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace firstlight::render {

/// Equations of one order that wait until there are enough of them to be solved side by side.
class RootBatch {
 public:
  static constexpr std::size_t kMostRoots = 10;

  std::size_t size() const { return count_; }
  bool takes(std::size_t order) const { return count_ == 0 || (count_ < kRaysAtOnce && order == polynomials_.order); }
  /// An equation of the ray with the shape's part: the sum of c[k * stride] x^k, for x from `low` to `high`.
  /// Pre: takes(order), low < high.
  void add(std::size_t ray, std::uint32_t part, std::size_t order, const double* c, std::size_t stride, double low,
           double high);
  void solve();
  void clear() { count_ = 0; }

  /// Facts of the i-th equation, when it is solved.
  std::size_t ray(std::size_t i) const { return ray_[i]; }
  std::uint32_t part(std::size_t i) const { return part_[i]; }
  std::size_t root_count(std::size_t i) const { return root_count_[i]; }
  double root(std::size_t i, std::size_t k) const { return root_[i][k]; }

 private:
  std::size_t count_ = 0;
  PolynomialColumns polynomials_;
  std::array<std::uint8_t, kRaysAtOnce> ray_;
  std::array<std::uint32_t, kRaysAtOnce> part_;
  std::array<std::uint8_t, kRaysAtOnce> root_count_;
  std::array<std::array<double, kMostRoots>, kRaysAtOnce> root_;
};

/// Equations of rays, or of points, with the parts of a shape. take(ray, part, root) is called for every root: of one ray
/// in the order in which its equations came, and ascending.
template <class Take>
class RootJobs {
 public:
  explicit RootJobs(Take take) : take_(std::move(take)) {}

  /// As RootBatch::add.
  void add(std::size_t ray, std::uint32_t part, std::size_t order, const double* c, std::size_t stride, double low,
           double high) {
    if (!batch_.takes(order)) finish();
    batch_.add(ray, part, order, c, stride, low, high);
  }
  /// Solves what still waits.
  void finish() {
    if (batch_.size() == 0) return;
    batch_.solve();
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      for (std::size_t k = 0; k < batch_.root_count(i); ++k) take_(batch_.ray(i), batch_.part(i), batch_.root(i, k));
    }
    batch_.clear();
  }

 private:
  Take take_;
  RootBatch batch_;
};

}  // namespace firstlight::render
