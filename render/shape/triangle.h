#pragma once

#include "render/shape/placed.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// The plane and the outline of a triangle, prepared for rays.
///
/// Source   POV-Ray 3.7: the outline is tested in the projection along the largest component of the normal; points on
///          an edge are in.
class FlatTriangle {
 public:
  using Corners = std::array<Vec3, 3>;
  static constexpr std::size_t kSlots = 1;

  explicit FlatTriangle(const Corners& corners);

  /// False: it has no area and is never met.
  bool valid() const { return valid_; }
  /// In the order of the outline test; `swapped()` when that exchanged the first two given.
  const Corners& corners() const { return corners_; }
  bool swapped() const { return swapped_; }
  const Vec3& normal() const { return normal_; }
  /// normal . p + offset = 0 in its plane.
  double offset() const { return offset_; }
  /// The axes of the projection.
  int u() const { return u_; }
  int v() const { return v_; }
  // Pre: valid.
  void meet(const Ray& ray, Met& met) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  Box3 bounds() const;

 private:
  Corners corners_;
  Vec3 normal_{0.0};
  double offset_ = 0.0;
  int u_ = 0;
  int v_ = 1;
  bool swapped_ = false;
  bool valid_ = false;
};

}  // namespace firstlight::render
