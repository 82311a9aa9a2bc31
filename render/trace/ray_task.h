#pragma once

#include "render/math/color.h"
#include "render/math/packed_rgb.h"
#include "render/math/vec.h"
#include "render/trace/ray_kind.h"

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

/// Rays that wait to be traced: a flat record with no pointer to a parent.
///
/// Meaning  A radiance ray adds weight * local light to its sample. A record of shadow feelers stands for light that
///          was added as if unoccluded, from one light or two; where a feeler is blocked, it takes back (1 - S) of the
///          light at stake, S being the share that passes.
/// Source   Yagel & Meeker 1997, eq. 2-9 and section 7; docs/paper-notes.md.
/// Memory   56 bytes.
class RayTask {
 public:
  static constexpr std::size_t kMostFeelers = 2;

  Vec3 origin;
  std::uint32_t sample = 0;  ///< index into the film
  std::uint32_t medium = 0;  ///< of MediumTable: what the ray travels in
  RayKind kind : kRayKindBits = RayKind::primary;
  std::uint8_t flags : 8 - kRayKindBits = 0;
  std::uint8_t level = 0;            ///< trace level of the parent: 0 for a primary ray
  std::uint16_t object = kNoObject;  ///< Part::object of the surface that the ray left

  static constexpr std::uint8_t kReflected = 1;  ///< a reflection lies on the way to the eye
  static constexpr std::uint8_t kContinued = 2;  ///< went straight on through a surface: does not raise the level
  /// Beside a ray that went through a surface: brings no light, but its weight's share of what shows through.
  static constexpr std::uint8_t kSeesThrough = 4;
  static constexpr std::uint16_t kNoObject = 0xffff;

  RayTask() : radiance_() {}

  // ---- Of every kind but shadow

  PackedDirection direction() const { return radiance_.direction; }
  void set_direction(PackedDirection direction) { radiance_.direction = direction; }
  /// Product of the factors on the way to the eye; of what sees through, one number three times.
  Rgb weight() const {
    return {std::bit_cast<float>(radiance_.red & kUpperBits), std::bit_cast<float>(radiance_.green & kUpperBits),
            std::bit_cast<float>(last_ & kUpperBits)};
  }
  bool is_black() const { return ((radiance_.red | radiance_.green | last_) & kMagnitude) == 0; }
  /// The largest channel of the weight in size.
  float max_weight() const {
    // The larger of two numbers without a sign has the larger bits.
    return std::bit_cast<float>(
        std::max({radiance_.red & kMagnitude, radiance_.green & kMagnitude, last_ & kMagnitude}));
  }
  /// Scalar weight by which POV-Ray prunes (adc_bailout).
  float adc_weight() const {
    return std::bit_cast<float>((last_ & kLowBits) << 24 | (radiance_.green & kLowBits) << 16 |
                                (radiance_.red & kLowBits) << 8);
  }
  /// Each component and `adc_weight` are kept to 16 significant bits: the weight is rounded to the nearest,
  /// `adc_weight` upwards, so that a ray which just reaches a bailout of few digits is traced.
  void set_weight(const Rgb& weight, float adc_weight) {
    const std::uint32_t adc = std::bit_cast<std::uint32_t>(adc_weight) + kLowBits;
    radiance_.red = rounded(weight.x) | (adc >> 8 & kLowBits);
    radiance_.green = rounded(weight.y) | (adc >> 16 & kLowBits);
    last_ = rounded(weight.z) | adc >> 24;
  }

  // ---- Of kind shadow

  /// Index into Scene::lights of the first feeler's light.
  std::uint32_t first_light() const { return last_ & kFirstLight; }
  /// Turns the record into one feeler; `at_stake` is the light exactly as it was added to the film. Pre: light <
  /// kMostLights.
  void set_feeler(std::uint32_t light, PackedRgb at_stake) {
    kind = RayKind::shadow;
    last_ = light;
    at_stake_[0] = at_stake;
    at_stake_[1] = PackedRgb();
  }
  /// Adds a feeler if there is room. Pre: `light` is larger than that in the record.
  bool add_feeler(std::uint32_t light, PackedRgb at_stake) {
    const std::uint32_t distance = light - first_light();
    if (to_second() != 0 || distance > kLowBits) return false;
    last_ |= distance << kFirstLightBits;
    at_stake_[1] = at_stake;
    return true;
  }
  /// Calls visit(index into Scene::lights, light at stake) for each feeler.
  template <class Visit>
  void for_each_feeler(const Visit& visit) const {
    visit(first_light(), at_stake_[0]);
    if (to_second() != 0) visit(first_light() + to_second(), at_stake_[1]);
  }

  /// How many rays the record stands for. To an area light that is one, for all the points of the light's grid.
  int ray_count() const { return kind == RayKind::shadow && to_second() != 0 ? 2 : 1; }

  static constexpr std::uint32_t kFirstLightBits = 24;
  static constexpr std::uint32_t kMostLights = 1u << kFirstLightBits;

 private:
  /// The low bits of the weight's three components, together, are the upper bits of the scalar weight.
  struct Radiance {
    PackedDirection direction;
    std::uint32_t red = 0;
    std::uint32_t green = 0;
  };
  static constexpr std::uint32_t kFirstLight = kMostLights - 1;
  static constexpr std::uint32_t kLowBits = 0xff;
  static constexpr std::uint32_t kUpperBits = ~kLowBits;
  static constexpr std::uint32_t kMagnitude = kUpperBits >> 1 & kUpperBits;  ///< without the sign

  static std::uint32_t rounded(float weight) {
    return (std::bit_cast<std::uint32_t>(weight) + (kLowBits + 1) / 2) & kUpperBits;
  }
  /// From the first feeler's light to the second's; 0: there is none.
  std::uint32_t to_second() const { return last_ >> kFirstLightBits; }

  std::uint32_t last_ = 0;  ///< of radiance rays: blue; of feelers: their lights
  union {
    Radiance radiance_;
    std::array<PackedRgb, kMostFeelers> at_stake_;
  };
};
static_assert(sizeof(RayTask) == 56);
static_assert(std::is_trivially_destructible_v<RayTask>);

/// Rays in `tasks`.
inline std::uint64_t ray_count(std::span<const RayTask> tasks) {
  std::uint64_t count = tasks.size();
  for (const RayTask& task : tasks) count += static_cast<std::uint64_t>(task.ray_count() - 1);
  return count;
}

}  // namespace firstlight::render
