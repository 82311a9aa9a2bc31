#pragma once

#include "render/shape/shape.h"

#include <array>
#include <cstddef>

namespace firstlight::render {

/// The plane and the outline of a triangle, prepared for rays.
///
/// Source   POV-Ray 3.7: the outline is tested in the projection along the largest component of the normal; points on
///          an edge are in.
class FlatTriangle {
 public:
  using Corners = std::array<Vec3, 3>;

  explicit FlatTriangle(const Corners& corners);

  /// False: it has no area and is never met.
  bool valid() const { return valid_; }
  /// In the order of the outline test; `swapped()` when that exchanged the first two given.
  const Corners& corners() const { return corners_; }
  bool swapped() const { return swapped_; }
  const Vec3& normal() const { return normal_; }
  /// The depth of the crossing, or a negative number.
  double meet(const Ray& ray) const;
  Box3 bounds() const;

 private:
  double edge_side(std::size_t from, std::size_t to, double u, double v) const;

  Corners corners_;
  Vec3 normal_{0.0};
  double offset_ = 0.0;
  int u_ = 0;
  int v_ = 1;
  bool swapped_ = false;
  bool valid_ = false;
};

}  // namespace firstlight::render
