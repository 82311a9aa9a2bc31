#pragma once

#include "render/math/color.h"
#include "render/math/packed_rgb.h"
#include "render/math/vec.h"
#include "render/scene/solid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
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

/// What a radiance ray (primary, reflection, transmission) carries beside its origin.
struct Radiance {
  PackedDirection direction;
  float red = 0.0f;  ///< weight: product of the factors on the way to the eye
  float green = 0.0f;
  float blue = 0.0f;
  float adc_weight = 1.0f;  ///< scalar weight by which POV-Ray prunes (adc_bailout)

  Rgb weight() const { return {red, green, blue}; }
  void set_weight(const Rgb& weight) {
    red = weight.x;
    green = weight.y;
    blue = weight.z;
  }
};

/// Rays that wait to be traced: a flat record with no pointer to a parent.
///
/// Meaning  A radiance ray adds weight * local light to its sample. A record of shadow feelers stands for light that
/// was
///          added as if unoccluded, from up to three lights; where a feeler is blocked, it takes back (1 - S) of the
///          light at stake, S being the share that passes.
/// Source   Yagel & Meeker 1997, eq. 2-9 and section 7; docs/paper-notes.md.
/// Memory   64 bytes.
class RayTask {
 public:
  static constexpr int kMostFeelers = 3;

  Vec3 origin;
  union {
    Radiance radiance;                                   ///< of every kind but shadow
    std::array<PackedRgb, kMostFeelers> light_at_stake;  ///< of kind shadow, exactly as it was added to the film
  };
  std::uint32_t sample = 0;  ///< index into the film
  std::uint32_t medium = 0;  ///< of MediumTable: what the ray travels in
  std::uint32_t path = 0;    ///< hash of the way from the eye, for random choices; of feelers: their lights, packed
  RayKind kind : 2 = RayKind::primary;
  std::uint8_t flags : 6 = 0;
  std::uint8_t level = 0;            ///< trace level of the parent: 0 for a primary ray
  std::uint16_t object = kNoObject;  ///< Part::object of the surface that the ray left

  static constexpr std::uint8_t kReflected = 1;  ///< a reflection lies on the way to the eye
  static constexpr std::uint8_t kContinued = 2;  ///< went straight on through a surface: does not raise the level
  static constexpr std::uint16_t kNoObject = 0xffff;

  RayTask() : radiance() {}

  /// Of kind shadow: index into Scene::lights of the first feeler's light.
  std::uint32_t first_light() const { return path & kFirstLight; }
  /// Of kind shadow: bit i set for light first_light() + 1 + i, in the order of light_at_stake.
  std::uint32_t more_lights() const { return path >> kFirstLightBits; }
  /// How many rays the record stands for.
  int ray_count() const {
    if (kind != RayKind::shadow) return 1;
    const std::uint32_t more = more_lights();  // at most two bits of it are set
    return 1 + (more != 0 ? 1 : 0) + ((more & (more - 1)) != 0 ? 1 : 0);
  }
  /// Turns the record into one feeler. Pre: light < kMostLights.
  void set_feeler(std::uint32_t light, PackedRgb at_stake) {
    kind = RayKind::shadow;
    path = light;
    light_at_stake[0] = at_stake;
  }
  /// Adds a feeler if there is room. Pre: `light` is larger than those in the record.
  bool add_feeler(std::uint32_t light, PackedRgb at_stake) {
    const std::uint32_t distance = light - first_light() - 1;
    if (distance >= 32 - kFirstLightBits || ray_count() == kMostFeelers) return false;
    light_at_stake[static_cast<std::size_t>(ray_count())] = at_stake;
    path |= std::uint32_t{1} << (kFirstLightBits + distance);
    return true;
  }
  /// Calls visit(index into Scene::lights, light at stake) for each feeler.
  template <class Visit>
  void for_each_feeler(const Visit& visit) const {
    visit(first_light(), light_at_stake[0]);
    std::size_t i = 1;
    for (unsigned bits = more_lights(); bits != 0; bits &= bits - 1) {
      visit(first_light() + 1 + static_cast<std::uint32_t>(std::countr_zero(bits)), light_at_stake[i++]);
    }
  }

  static constexpr std::uint32_t kFirstLightBits = 24;
  static constexpr std::uint32_t kMostLights = 1u << kFirstLightBits;

 private:
  static constexpr std::uint32_t kFirstLight = kMostLights - 1;
};
static_assert(sizeof(RayTask) == 64);
static_assert(std::is_trivially_destructible_v<RayTask>);

/// Rays in `tasks`.
inline std::uint64_t ray_count(std::span<const RayTask> tasks) {
  std::uint64_t count = tasks.size();
  for (const RayTask& task : tasks) count += static_cast<std::uint64_t>(task.ray_count() - 1);
  return count;
}

}  // namespace firstlight::render
