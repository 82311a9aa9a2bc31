#include "render/trace/surroundings_limits.h"

#include "render/surface/pigment_limits.h"

#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

bool is_share(float value) { return value >= 0.0f && value <= 1.0f; }
double size_of(const Rgb& color) { return static_cast<double>(max_magnitude(color)); }

/// Largest factor of 1 - f + f * color, for f from 0 to `filter`.
double largest_tint(const FilteredColor& color) {
  double most = 1.0;
  for (const double channel : channels_of(color.rgb)) {
    most = std::max(most, std::abs(1.0 + static_cast<double>(color.filter) * (channel - 1.0)));
  }
  return most;
}

bool shows(const Fog& fog) { return std::abs(fog.distance) > kNegligible; }

/// Whether what is left of light is a share of it.
bool takes(const Fog& fog) {
  return fog.distance > 0.0 && fog.color.transmit <= 1.0f && (fog.type != Fog::kGround || fog.altitude != 0.0);
}

VeilLimits over(const VeilLimits& first, const VeilLimits& second) {
  return {first.kept * second.kept, second.kept * first.added + second.added, second.over(first.least)};
}

/// Behind fogs: what each takes is a share, so that of one fog no more is seen than it shows at its thickest, or than
/// comes through; several add.
VeilLimits fog_limits(const Scene& scene, bool& proven) {
  VeilLimits limits;
  int count = 0;
  for (const Fog& fog : scene.atmosphere.fogs) {
    if (!shows(fog)) continue;
    ++count;
    proven = proven && takes(fog);
    limits.kept *= largest_tint(fog.color);
    limits.added += size_of(fog.color.rgb);
  }
  if (count == 1) return {limits.kept, 0.0, limits.added};
  return limits;
}

VeilLimits bow_limits(const Scene& scene, bool& proven) {
  VeilLimits limits;
  for (const Rainbow& bow : scene.atmosphere.rainbows) {
    if (!bow.shows()) continue;
    proven = proven && bow.distance > 0.0;
    for (const ColorMapEntry& entry : bow.colors) {
      proven = proven && is_share(entry.color.filter) && is_share(entry.color.transmit);
      limits.kept = std::max(limits.kept, largest_tint(entry.color));
      limits.least = std::max(limits.least, size_of(entry.color.rgb));
    }
  }
  return limits;
}

}  // namespace

VeilLimits veil_limits(const Scene& scene, bool& proven) {
  return over(bow_limits(scene, proven), fog_limits(scene, proven));
}

double sky_limit(const Scene& scene, bool& proven) {
  const Settings& settings = scene.settings;
  const double background = std::max(size_of(settings.background), size_of(settings.background_with_alpha.rgb));
  if (!scene.atmosphere.sky_sphere) return background;
  const SkySphere& sky = *scene.atmosphere.sky_sphere;
  double light = 0.0;
  double passed = 1.0;
  for (auto pigment = sky.pigments.rbegin(); pigment != sky.pigments.rend(); ++pigment) {
    const PigmentLimits limits(*pigment, 370, !settings.quality.has_pigments());
    proven = proven && limits.is_known && !pigment->pattern->pigments;
    light += passed * std::max({limits.body[0], limits.body[1], limits.body[2]});
    passed *= limits.most_passed();
    // Filters multiply by old rules, for which this is a bound if all shares are such and colours are not above 1.
    if (settings.language_version < 370) {
      const bool usual = limits.only_takes() && !limits.may_turn_negative() && limits.most_color() <= 1.0;
      proven = proven && usual;
      passed = 1.0;
    }
  }
  return light * size_of(sky.emission) + passed * background;
}

bool surroundings_may_be_negative(const Scene& scene) {
  const auto is_negative = [](const Rgb& color) { return std::min({color.x, color.y, color.z}) < 0.0f; };
  const Atmosphere& atmosphere = scene.atmosphere;
  for (const Fog& fog : atmosphere.fogs) {
    if (shows(fog) && (is_negative(fog.color.rgb) || !takes(fog) || !is_share(fog.color.filter))) return true;
  }
  for (const Rainbow& bow : atmosphere.rainbows) {
    for (const ColorMapEntry& entry : bow.colors) {
      if (is_negative(entry.color.rgb) || !is_share(entry.color.filter) || !is_share(entry.color.transmit)) return true;
    }
  }
  if (!atmosphere.sky_sphere) return false;
  return is_negative(atmosphere.sky_sphere->emission) ||
         std::ranges::any_of(atmosphere.sky_sphere->pigments,
                             [](const Pigment& pigment) { return PigmentLimits(pigment, 370).may_turn_negative(); });
}

}  // namespace firstlight::render
