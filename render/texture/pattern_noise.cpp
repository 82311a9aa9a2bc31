// Patterns made of smooth noise.

#include "render/texture/lane_field.h"
#include "render/texture/patterns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture/pattern_noise.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"
#include "render/math/noise-inl.h"
#include "render/texture/lane_field-inl.h"

#include <variant>

#ifndef FIRSTLIGHT_RENDER_TEXTURE_PATTERN_NOISE
#define FIRSTLIGHT_RENDER_TEXTURE_PATTERN_NOISE
namespace firstlight::render {
namespace {

/// Noise itself; `spotted` is another word for it.
struct Bozo {
  int generator;
};
/// As bozo, but that it tilts normals by a noise vector.
struct Bumps {
  int generator;
};
struct Dents {
  int generator;
};
/// Six octaves of ridges, each half as strong as the one before.
struct Granite {
  int generator;
};
/// Ten octaves, of which all but the oldest generator stretch the middle half of their range.
struct Wrinkles {
  int generator;
};
using NoiseFormula = std::variant<Bozo, Bumps, Dents, Granite, Wrinkles>;

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE L value(const Bozo& bozo, const Vec3Of<L>& p) {
  return noise(p, bozo.generator);
}

template <class L>
HWY_INLINE L value(const Bumps& bumps, const Vec3Of<L>& p) {
  return noise(p, bumps.generator);
}
template <class L>
HWY_INLINE Vec3Of<L> tilt(const Bumps&, const Vec3Of<L>& p, const Tilting& tilting) {
  return dnoise(p) * L(tilting.amount);
}

template <class L>
HWY_INLINE L value(const Dents& dents, const Vec3Of<L>& p) {
  const L height = noise(p, dents.generator);
  return height * height * height;
}
template <class L>
HWY_INLINE Vec3Of<L> tilt(const Dents& dents, const Vec3Of<L>& p, const Tilting& tilting) {
  return dnoise(p) * (value(dents, p) * tilting.amount);
}

template <class L>
HWY_INLINE L value(const Granite& granite, const Vec3Of<L>& p) {
  L sum = 0.0;
  double scale = 1.0;
  const Vec3Of<L> start = p * L(4.0);
  for (int octave = 0; octave < 6; ++octave, scale *= 2.0) {
    const L height = noise(start * L(scale), granite.generator);
    const L ridge = granite.generator == 1 ? abs(0.5 - height) : min(abs(1.0 - 2.0 * height), 0.5);
    sum = sum + ridge / scale;
  }
  return sum;
}

template <class L>
HWY_INLINE L value(const Wrinkles& wrinkles, const Vec3Of<L>& p) {
  L sum = 0.0;
  double lambda = 1.0, omega = 1.0;
  for (int octave = 0; octave < 10; ++octave, lambda *= 2.0, omega *= 0.5) {
    L height = noise(p * L(lambda), wrinkles.generator);
    if (wrinkles.generator > 1) height = clamp(height * 2.0 - 0.5, 0.0, 1.0);
    sum = sum + omega * height;
  }
  return sum / 2.0;
}
/// Sizes of noise vectors, ten octaves.
template <class L>
HWY_INLINE Vec3Of<L> tilt(const Wrinkles&, const Vec3Of<L>& p, const Tilting& tilting) {
  Vec3Of<L> sum = {L(0.0), L(0.0), L(0.0)};
  double scale = 1.0;
  for (int octave = 0; octave < 10; ++octave, scale *= 2.0) {
    const Vec3Of<L> crease = dnoise(p * L(scale)) / L(scale);
    sum = sum + Vec3Of<L>{abs(crease.x), abs(crease.y), abs(crease.z)};
  }
  return sum * L(tilting.amount);
}

void noise_values(const NoiseFormula& formula, const Columns3<double>& at, std::size_t count, Column<double>& values) {
  std::visit([&](const auto& f) { values_at(f, at, count, values); }, formula);
}

void noise_tilts(const NoiseFormula& formula, const Tilting& tilting, const Columns3<double>& at, std::size_t count,
                 Columns3<double>& normals) {
  if (const auto* bumps = std::get_if<Bumps>(&formula)) tilt_at(*bumps, tilting, at, count, normals);
  if (const auto* dents = std::get_if<Dents>(&formula)) tilt_at(*dents, tilting, at, count, normals);
  if (const auto* wrinkles = std::get_if<Wrinkles>(&formula)) tilt_at(*wrinkles, tilting, at, count, normals);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(noise_values);
HWY_EXPORT(noise_tilts);

void values_of(const NoiseFormula& formula, const Columns3<double>& at, std::size_t count, Column<double>& values) {
  HWY_DYNAMIC_DISPATCH(noise_values)(formula, at, count, values);
}
void tilts_of(const NoiseFormula& formula, const Tilting& tilting, const Columns3<double>& at, std::size_t count,
              Columns3<double>& normals) {
  HWY_DYNAMIC_DISPATCH(noise_tilts)(formula, tilting, at, count, normals);
}

PatternPtr without_tilt(const NoiseFormula& formula) { return make_lane_field(formula, values_of); }
PatternPtr with_tilt(const NoiseFormula& formula) { return make_lane_field(formula, values_of, tilts_of); }

}  // namespace

PatternPtr pattern::make_bozo(const PatternRequest& request) { return without_tilt(Bozo{request.noise_generator}); }
PatternPtr pattern::make_bumps(const PatternRequest& request) { return with_tilt(Bumps{request.noise_generator}); }
PatternPtr pattern::make_dents(const PatternRequest& request) { return with_tilt(Dents{request.noise_generator}); }
PatternPtr pattern::make_granite(const PatternRequest& request) {
  return without_tilt(Granite{request.noise_generator});
}
PatternPtr pattern::make_wrinkles(const PatternRequest& request) {
  return with_tilt(Wrinkles{request.noise_generator});
}

}  // namespace firstlight::render
#endif
