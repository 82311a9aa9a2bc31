#pragma once

#include "render/accel/accel.h"
#include "render/accel/ray_block.h"
#include "render/light/arrival.h"
#include "render/light/light.h"
#include "render/shape/shape.h"
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

/// One layer of the hits' textures. Where a hit has no such layer, all amounts are 0.
struct LayerColumns {
  Columns3<double> color;  ///< of the pigment
  Columns3<double> share;  ///< the ray's weight, and what the layers above let through
  Column<double> diffuse;  ///< amounts times the layer's opacity
  Column<double> specular;
  Column<double> specular_exponent;

  /// Bits of the hits that are tilted here. While it is 0, the column of normals holds nothing.
  std::uint64_t tilted = 0;
  Columns3<double> normal;  ///< where nothing tilts it, the hit's

  /// Whether any of the hits has what follows; the columns hold nothing else.
  bool has_rare = false;
  Column<double> diffuse_back;
  Column<double> brilliance;
  Column<double> phong;
  Column<double> phong_size;
  Column<double> metallic;
  Column<double>
      crand;  ///< most that chance takes from the diffuse light of one light, of a white surface, however clear
  Column<double> crand_back;  ///< the same behind it
  Column<double> irid;        ///< strength of the colours of a thin film
  Column<double> film;        ///< its thickness, in the unit of HitBlock::irid_wavelength
};

/// Hits side by side, to be lit together. Plain data.
struct HitBlock : SurfacePlaces {
  std::size_t size = 0;
  std::size_t capacity = 0;  ///< hits there may be
  Columns3<double> direction;  ///< of the rays
  Columns3<double> normal;     ///< unit, towards the rays' origins
  Column<double> lit_from;     ///< the least cosine to the normal under which a light shines on the front
  Columns3<double> own_light;  ///< times the ray's weight
  std::vector<LayerColumns> layers;
  std::size_t layer_count = 0;   ///< of the hit that has most
  bool lit_from_behind = false;  ///< any of them, by a light at its back

  void begin(std::size_t most_hits) {
    size = 0;
    clear_feelers = 0;
    blocked_feelers = 0;
    lit_from_behind = false;
    capacity = most_hits;
    layer_count = 0;
  }

  /// Bits of the hits that each light may shine on.
  std::array<std::uint64_t, kLightsAtOnce> reached = all_reached();
  static std::array<std::uint64_t, kLightsAtOnce> all_reached() {
    std::array<std::uint64_t, kLightsAtOnce> all;
    all.fill(~std::uint64_t{0});
    return all;
  }

  std::vector<Arrival> arrivals;               ///< room for those of lights that are not plain
  std::vector<Columns3<double>> spread_light;  ///< the same of area lights whose points light one by one

  Vec3 irid_wavelength{0.0};      ///< of red, green and blue
  std::uint64_t first_light = 0;  ///< number of the first of the lights that shine in one go
  bool feelers_may_gain = false;  ///< what they cross may make more light of theirs: RadianceBound::most_of_feelers()
  std::array<Foreseen, kLightsAtOnce> foreseen{};  ///< of the feelers to each light

  // light_hits() finds:
  Column<std::int64_t> mirrored;  ///< packed direction of the mirrored ray: u low, v high
  Columns3<std::int64_t> sum;     ///< light for the film, FixedRgb
  Column<std::int64_t> at_stake;  ///< RadianceBound::at_stake() of the record
  // for each light:
  std::array<std::uint64_t, kLightsAtOnce> open;           ///< bits of the hits from which a feeler is to be traced
  std::array<Column<std::uint64_t>, kLightsAtOnce> light;  ///< PackedRgb of what that may take back
  // Those that need not be traced:
  std::size_t clear_feelers = 0;
  std::size_t blocked_feelers = 0;  ///< whose light has not been added
};

/// Starts the sums with the hits' own light, and mirrors the rays.
void begin_light(HitBlock& block);
/// Adds the light of `lights` as if nothing were in the way of it but what is foreseen. What is added is what feelers
/// can keep, so that a blocked light leaves nothing behind. Pre: at most kLightsAtOnce lights. Source   POV-Ray 3.7's
/// diffuse, phong and specular terms; see light_block.cpp.
void light_hits(HitBlock& block, std::span<const Light> lights);

/// Where feelers to a light lead: its position, 0, and nothing; of parallel ones its position, 1, and the direction to
/// it.
using LightPlace = std::array<double, 8>;
LightPlace place_of(const Light& light);

/// Feelers side by side. Plain data.
struct FeelerBlock {
  RayBlock rays;  ///< add() sets the origins, aim_feelers() the rest
  Column<std::int64_t> light;
  Column<std::uint64_t> at_stake;  ///< PackedRgb

  std::size_t size() const { return rays.size; }
  std::size_t room() const { return kRaysAtOnce - rays.size; }
  void add(const Vec3& origin, std::uint32_t to_light, PackedRgb held) {
    const std::size_t i = rays.size++;
    rays.origin.set(i, origin);
    light[i] = to_light;
    at_stake[i] = held.bits();
  }

  // weigh_feelers() finds:
  Columns3<std::int64_t> steps;  ///< light at stake, FixedRgb
};

/// Aims the feelers at their lights.
void aim_feelers(FeelerBlock& block, std::span<const LightPlace> lights);
/// Unpacks what they hold.
void weigh_feelers(FeelerBlock& block);

/// Unpacks directions, u in the low half and v in the high half of each number.
void unpack_directions(const Column<std::int64_t>& packed, std::size_t count, Columns3<double>& directions);

}  // namespace firstlight::render
