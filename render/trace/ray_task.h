#pragma once

#include "render/math/color.h"
#include "render/math/vec.h"
#include "render/scene/solid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace firstlight::render {

/// A unit vector in 8 bytes: octahedral coordinates, 32 bits each; decodes within 1e-9 of what was encoded.
/// Source   Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 3(2), 2014.
struct PackedDirection {
  std::int32_t u = 0;
  std::int32_t v = 0;

  PackedDirection() = default;
  explicit PackedDirection(const Vec3& d) {
    const double scale = 1.0 / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    double x = d.x * scale;
    double y = d.y * scale;
    if (d.z < 0.0) {
      const double folded = (1.0 - std::abs(y)) * (x >= 0.0 ? 1.0 : -1.0);
      y = (1.0 - std::abs(x)) * (y >= 0.0 ? 1.0 : -1.0);
      x = folded;
    }
    u = static_cast<std::int32_t>(std::lrint(x * kSteps));
    v = static_cast<std::int32_t>(std::lrint(y * kSteps));
  }
  Vec3 unpack() const {
    double x = u * (1.0 / kSteps);
    double y = v * (1.0 / kSteps);
    const double z = 1.0 - std::abs(x) - std::abs(y);
    const double fold = std::max(-z, 0.0);
    x += x >= 0.0 ? -fold : fold;
    y += y >= 0.0 ? -fold : fold;
    const double inverse_length = 1.0 / std::sqrt(x * x + y * y + z * z);
    return {x * inverse_length, y * inverse_length, z * inverse_length};
  }

  static constexpr double kSteps = 2147483647.0;
};

/// A ray that waits to be traced: a flat record with no pointer to its parent.
///
/// Meaning  A radiance ray (primary, reflection, transmission) adds weight * local light to its sample. A shadow feeler
///          stands for light that was added as if unoccluded: where it is blocked, it takes back weight * (1 - S),
///          S being the share of light that passes. [Yagel & Meeker 1997, eq. 2-9; docs/paper-notes.md]
/// Memory   64 bytes.
struct RayTask {
  Vec3 origin;
  PackedDirection direction;        ///< of a radiance ray
  Rgb weight;                       ///< radiance: product of the factors on the way to the eye; shadow: the light at stake
  float adc_weight = 1.0f;          ///< scalar weight by which POV-Ray prunes (adc_bailout)
  std::uint32_t sample = 0;         ///< index into the film
  std::uint32_t medium = 0;         ///< of MediumTable: what the ray travels in
  std::uint32_t path = 0;           ///< hash of the way from the eye, for random choices
  RayKind kind = RayKind::primary;
  std::uint8_t level = 0;           ///< trace level of the parent: 0 for a primary ray
  std::uint8_t flags = 0;
  std::uint8_t unused = 0;

  static constexpr std::uint8_t kReflected = 1;  ///< a reflection lies on the way to the eye
  static constexpr std::uint8_t kContinued = 2;  ///< went straight on through a surface: does not raise the level

  /// Of a shadow feeler: index into Scene::lights; kept where a radiance ray has its direction.
  std::uint32_t light() const { return static_cast<std::uint32_t>(direction.u); }
  void set_light(std::uint32_t index) { direction.u = static_cast<std::int32_t>(index); }
};
static_assert(sizeof(RayTask) == 64);
static_assert(std::is_trivially_destructible_v<RayTask>);

}  // namespace firstlight::render
