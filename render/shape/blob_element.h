#pragma once

#include "render/math/transform.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace firstlight::render {

/// A ball, or one of the three parts of a cylinder: a half ball at each end, and what is between. Its field is
/// c0 d^4 + c1 d^2 + c2, d being the distance from the middle or the axis.
struct BlobElement {
  enum class Kind : std::uint8_t { ball, base, middle, top };

  Kind kind;
  Vec3 center;          ///< of a ball
  double height = 0.0;  ///< of a cylinder, which stands on the origin along z
  double radius_squared;
  double c0, c1, c2;
  Transform placement;  ///< to the blob's space
  std::uint32_t texture;

  Vec3 local(const Vec3& point) const { return placement.is_identity() ? point : placement.inverse_point(point); }
  Vec3 foot() const { return kind == Kind::ball ? center : Vec3(0.0, 0.0, kind == Kind::top ? height : 0.0); }

  /// The step from the middle or the axis to the point, in the element's space; nothing where there is no field.
  std::optional<Vec3> from_middle(const Vec3& point) const {
    const Vec3 there = local(point);
    Vec3 step = there - foot();
    if (kind == Kind::base && step.z > 0.0) return std::nullopt;
    if (kind == Kind::top && step.z < 0.0) return std::nullopt;
    if (kind == Kind::middle) {
      if (there.z < 0.0 || there.z > height) return std::nullopt;
      step.z = 0.0;
    }
    if (step.length2() > radius_squared) return std::nullopt;
    return step;
  }
  double field(const Vec3& point) const {
    const std::optional<Vec3> step = from_middle(point);
    if (!step) return 0.0;
    const double d2 = step->length2();
    return d2 * (d2 * c0 + c1) + c2;
  }
  /// Minus the gradient of its field.
  Vec3 normal(const Vec3& point) const {
    const std::optional<Vec3> step = from_middle(point);
    if (!step) return Vec3(0.0);
    return placement.normal(*step) * (-2.0 * c0 * step->length2() - c1);
  }
  Box3 bounds() const {
    const double reach =
        kind == Kind::middle ? std::sqrt(radius_squared + 0.25 * height * height) : std::sqrt(radius_squared);
    const Vec3 middle = kind == Kind::middle ? Vec3(0.0, 0.0, 0.5 * height) : foot();
    if (placement.is_identity()) return Box3(middle - Vec3(reach), middle + Vec3(reach));
    const Vec3 there = placement.point(middle);
    const Vec3 sides = placement.box(Box3(Vec3(0.0), Vec3(reach))).size();
    const double longest = std::max({sides.x, sides.y, sides.z});
    const double room = std::sqrt(longest * longest + kEpsilon);
    return Box3(there - Vec3(room), there + Vec3(room));
  }
};

}  // namespace firstlight::render
