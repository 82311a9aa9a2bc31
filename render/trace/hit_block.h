#pragma once

#include "render/accel/ray_block.h"
#include "render/light/light.h"
#include "render/trace/ray_task.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// How many lights shine on a HitBlock in one go.
constexpr std::size_t kLightsAtOnce = 8;

/// What the hits' textures have in one layer. Where a hit has no such layer, all amounts are 0.
struct LayerColumns {
  Columns3<double> color;  ///< of the pigment
  Columns3<double> share;  ///< the ray's weight, and what the layers above let through
  Column<double> diffuse;  ///< amounts times the layer's opacity
  Column<double> diffuse_back;
  Column<double> brilliance;
  Column<double> phong;
  Column<double> phong_size;
  Column<double> specular;
  Column<double> specular_exponent;
  Column<double> metallic;
};

/// Hits side by side, to be lit together. Plain data.
struct HitBlock {
  std::size_t size = 0;
  std::size_t capacity = 0;  ///< hits there may be
  Columns3<double> point;
  Columns3<double> direction;  ///< of the rays
  Columns3<double> normal;     ///< unit, towards the rays' origins
  Column<double> lit_from;     ///< the least cosine to the normal under which a light shines on the front
  Columns3<double> own_light;  ///< times the ray's weight
  std::vector<LayerColumns> layers;
  std::size_t layer_count = 0;   ///< of the hit that has most
  bool lit_from_behind = false;  ///< any of them, by a light at its back

  void begin(std::size_t most_hits) {
    size = 0;
    lit_from_behind = false;
    capacity = most_hits;
    layer_count = 0;
  }

  // What light_hits() finds:
  Column<std::int64_t> mirrored;  ///< packed direction of the mirrored ray: u low, v high
  Columns3<std::int64_t> sum;     ///< light for the film, FixedRgb
  Column<std::int64_t> at_stake;  ///< RadianceBound::at_stake() of the record
  std::array<Column<std::uint64_t>, kLightsAtOnce>
      light;  ///< of each light: PackedRgb of what its feeler may take back
};

/// Starts the sums with the hits' own light, and mirrors the rays.
void begin_light(HitBlock& block);
/// Adds the light of `lights` as if nothing were in the way. What is added is what feelers can keep, so that a blocked
/// light leaves nothing behind. Pre: at most kLightsAtOnce lights.
/// Source   POV-Ray 3.7's diffuse, phong and specular terms; see light_block.cpp.
void light_hits(HitBlock& block, std::span<const Light> lights);

/// Where a light is; the fourth number is unused.
using LightPlace = std::array<double, 4>;

/// Feelers of records side by side: of each record the first, the second or the third.
struct FeelerBlock {
  std::size_t size = 0;
  Columns3<double> origin;
  struct Slot {
    Column<std::int64_t> light;      ///< index; any valid one where there is no feeler
    Column<std::uint64_t> at_stake;  ///< PackedRgb; 0 where there is no feeler
    RayBlock rays;                   ///< filled by aim_feelers()
    std::uint64_t blocked = 0;       ///< bits of the feelers that something opaque blocks
  };
  std::array<Slot, RayTask::kMostFeelers> slots;
  std::size_t slot_count = 0;

  void begin(std::size_t records) {
    size = records;
    slot_count = 0;
  }
  void add(std::size_t record, std::size_t slot, std::uint32_t light, PackedRgb at_stake) {
    if (slot == slot_count) {
      std::fill_n(slots[slot].at_stake.at.begin(), size, 0);
      ++slot_count;
    }
    slots[slot].light[record] = light;
    slots[slot].at_stake[record] = at_stake.bits();
  }

  // What take_back() finds:
  Columns3<std::int64_t> sum;     ///< light of the blocked feelers, FixedRgb
  Column<std::int64_t> at_stake;  ///< RadianceBound::at_stake() of the record
};

/// POV-Ray 3.7: a feeler ignores what is closer than this to either of its ends, in scene units.
constexpr double kShadowGap = 1e-3;
/// Fills the rays of all slots; they meet nothing where there is no feeler.
void aim_feelers(FeelerBlock& block, std::span<const LightPlace> lights);
/// Adds up what blocked feelers take back, and what all of them might have.
void take_back(FeelerBlock& block);

/// Unpacks directions, u in the low half and v in the high half of each number.
void unpack_directions(const Column<std::int64_t>& packed, std::size_t count, Columns3<double>& directions);

}  // namespace firstlight::render
