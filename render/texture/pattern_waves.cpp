// Rings about several points: ripples, and waves, whose rings are of different width.

#include "render/math/noise.h"
#include "render/math/single.h"
#include "render/texture/lane_field.h"
#include "render/texture/patterns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture/pattern_waves.cpp"
#include <hwy/foreach_target.h>

#include "render/texture/lane_field-inl.h"
#include "render/texture/wave-inl.h"

#include <cstdint>
#include <vector>

#ifndef FIRSTLIGHT_RENDER_TEXTURE_PATTERN_WAVES
#define FIRSTLIGHT_RENDER_TEXTURE_PATTERN_WAVES
namespace firstlight::render {
namespace {

struct RingSource {
  Vec3 place;
  double frequency = 1.0;
};

/// Frequency and phase say how far rings are apart; they then shape the value once more, as they do all values.
struct Rings {
  std::vector<RingSource> sources;
  Wave wave;
  bool differ;
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE L length_but_0(const Vec3Of<L>& way) {
  const L distance = length(way);
  return select(distance == 0.0, L(1.0), distance);
}
/// How high the rings of a source stand so far from it.
template <class L>
HWY_INLINE L ring(const L& distance, const RingSource& source, const Wave& wave) {
  const double frequency = in_single(wave.frequency), phase = in_single(wave.phase);
  return sine_wave(distance * frequency * source.frequency + phase);
}

template <class L>
HWY_INLINE L value(const Rings& rings, const Vec3Of<L>& p) {
  L sum = 0.0;
  for (const RingSource& source : rings.sources) {
    sum = sum + ring(length_but_0(p - everywhere<L>(source.place)), source, rings.wave) / source.frequency;
  }
  const L mean = sum / static_cast<double>(rings.sources.size());
  return rings.differ ? 0.2 * (2.5 + mean) : 0.5 * (1.0 + mean);
}

void ring_values(const Rings& rings, const Columns3<double>& at, std::size_t count, Column<double>& values) {
  values_at(rings, at, count, values);
}

void ring_tilts(const Rings& rings, const Tilting& tilting, const Columns3<double>& at, std::size_t count,
                Columns3<double>& normals) {
  const auto sources = static_cast<double>(rings.sources.size());
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    const Vec3Of<Lanes> p = load3<Lanes>(at, i);
    Vec3Of<Lanes> normal = load3<Lanes>(normals, i);
    for (const RingSource& source : rings.sources) {
      const Vec3Of<Lanes> way = p - everywhere<Lanes>(source.place);
      const Lanes distance = length_but_0(way);
      const Lanes height = ring(distance, source, tilting.wave) * tilting.amount / source.frequency;
      normal = normal + way * (height / (distance * sources));
    }
    store3(normal, normals, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(ring_values);
HWY_EXPORT(ring_tilts);

/// At random places on the unit sphere; of waves, with random frequencies. The numbers are POV-Ray 3.7's.
std::vector<RingSource> ring_sources(int count, bool differ) {
  std::vector<RingSource> result;
  std::uint32_t random = static_cast<std::uint32_t>(-560851967);
  for (int i = 0; i < count; ++i) {
    RingSource source;
    source.place = dnoise(Vec3(i, 0.0, 0.0)).normalized();
    random = random * 1812433253u + 12345u;
    if (differ) source.frequency = static_cast<double>(random >> 16 & 0x7fffu) * 0.000030518509476 + 0.01;
    result.push_back(source);
  }
  return result;
}

PatternPtr make_rings(const PatternRequest& request, bool differ) {
  return make_lane_field(
      Rings{ring_sources(request.world.number_of_waves, differ), request.wave, differ},
      [](const Rings& rings, const Columns3<double>& at, std::size_t count, Column<double>& values) {
        HWY_DYNAMIC_DISPATCH(ring_values)(rings, at, count, values);
      },
      [](const Rings& rings, const Tilting& tilting, const Columns3<double>& at, std::size_t count,
         Columns3<double>& normals) { HWY_DYNAMIC_DISPATCH(ring_tilts)
                                      (rings, tilting, at, count, normals); });
}

}  // namespace

PatternPtr pattern::make_ripples(const PatternRequest& request) { return make_rings(request, false); }
PatternPtr pattern::make_waves(const PatternRequest& request) { return make_rings(request, true); }

}  // namespace firstlight::render
#endif
