#include "render/trace/surface_limits.h"

#include "render/lanes/math.h"
#include "render/surface/pigment_limits.h"
#include "render/trace/start_medium.h"
#include "render/trace/surroundings_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <unordered_set>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

/// A term that has no largest value is taken for so many times its usual largest. An estimate.
constexpr double kUsualExcess = 4.0;

double largest(const Channels& c) { return std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2])}); }

bool is_negative(const Rgb& color) { return std::min({color.x, color.y, color.z}) < 0.0f; }

/// Whether the layer may make negative light of light that is not.
bool may_turn_negative(const TextureLayer& layer, int language_version, bool quick_colors) {
  const Finish& finish = layer.finish;
  const bool mirrors_too_much = finish.conserve_energy && std::max(max_component(finish.reflection_min),
                                                                   max_component(finish.reflection_max)) > 1.0f;
  return is_negative(finish.ambient) || is_negative(finish.emission) || is_negative(finish.reflection_min) ||
         is_negative(finish.reflection_max) || finish.reflection_metallic < 0.0 || finish.reflection_metallic > 1.0 ||
         finish.metallic > 1.0 || finish.crand > 0.0 || finish.irid > 1.0 || mirrors_too_much ||
         PigmentLimits(layer.pigment, language_version, quick_colors).may_turn_negative();
}

/// Whether there may be negative light anywhere in the scene.
bool may_be_negative(const Scene& scene, const SurfaceTable& surfaces) {
  const Settings& settings = scene.settings;
  return is_negative(settings.background) || is_negative(settings.ambient_light) ||
         surroundings_may_be_negative(scene) ||
         std::ranges::any_of(scene.lights, [](const Light& light) { return is_negative(light.color); }) ||
         std::ranges::any_of(scene.interiors,
                             [](const Interior& interior) {
                               return interior.refraction_scale < 0.0 || is_negative(interior.fade_color) ||
                                      max_component(interior.fade_color) > 1.0f;
                             }) ||
         std::ranges::any_of(surfaces.all_layers(), [&](const SurfaceLayer& layer) {
           return may_turn_negative(*layer.source, settings.language_version, !settings.quality.has_pigments());
         });
}

/// Largest factor of metallic_tint(): 1 + (color - 1) m, for m from 0 to `metallic`.
double largest_tint(double metallic, const Range& color) {
  return std::max(1.0, std::abs(1.0 - metallic) + std::abs(metallic) * color.size());
}

class Maker {
 public:
  Maker(const Scene& scene, const SurfaceTable& surfaces, const Box3& origins, SurfaceLimits& limits)
      : scene_(scene), surfaces_(surfaces), limits_(limits) {
    add_lights();
    look_at_matter(origins);
  }

  void add(const Coat& coat);

 private:
  /// To be called for what a bound depends on.
  void need(bool condition) { limits_.proven = limits_.proven && condition; }
  /// The factor on a largest value that holds under a condition.
  double usual(bool condition) {
    need(condition);
    return condition ? 1.0 : kUsualExcess;
  }
  bool has_negative_light() {
    if (!negative_light_) negative_light_ = may_be_negative(scene_, surfaces_);
    return *negative_light_;
  }
  void keep(const SurfaceAnswer& answer);
  void add_lights();
  void look_at_matter(const Box3& origins);
  double lit(const Finish& finish, const PigmentLimits& pigment, std::size_t channel);
  double mirror_of(const Finish& finish, const PigmentLimits& pigment);

  const Scene& scene_;
  const SurfaceTable& surfaces_;
  SurfaceLimits& limits_;
  Channels diffuse_lights_{};           ///< sum of all lights at their brightest
  Channels shining_lights_{};           ///< of those that give highlights
  double matter_ = 1.0;                 ///< most that is left of light that crossed matter
  std::optional<bool> negative_light_;  ///< found when it is asked for
  bool bends_ = false;                  ///< rays may be bent
  bool goes_straight_ = true;           ///< rays may go straight on
};

/// Whether the other answer is of less light than this, whatever comes.
bool exceeds(const SurfaceAnswer& answer, const SurfaceAnswer& other) {
  return other.sealed.empty() && answer.own >= other.own && answer.mirrored >= other.mirrored &&
         answer.straight >= other.straight && answer.bent >= other.bent;
}

/// Only the largest answers count: where there are many surfaces, most of them are exceeded by one of the first.
void Maker::keep(const SurfaceAnswer& answer) {
  constexpr std::size_t kMostCompared = 16;
  const std::span first = std::span(limits_.answers).first(std::min(limits_.answers.size(), kMostCompared));
  if (std::ranges::any_of(first, [&](const SurfaceAnswer& kept) { return exceeds(kept, answer); })) return;
  const auto exceeded = std::ranges::find_if(first, [&](const SurfaceAnswer& kept) { return exceeds(answer, kept); });
  if (exceeded != first.end()) {
    *exceeded = answer;
  } else {
    limits_.answers.push_back(answer);
  }
}

void Maker::add_lights() {
  for (const Light& light : scene_.lights) {
    double factor = 1.0;
    if (light.fade_power > 0.0 && std::abs(light.fade_distance) > kNegligible) {
      // Behind a parallel light the distance is negative, and only its even powers are not.
      const bool is_bounded = light.fade_distance > 0.0 && (!light.parallel || std::fmod(light.fade_power, 2.0) == 0.0);
      factor = 2.0 * usual(is_bounded);
    }
    if (light.kind != LightKind::point) factor *= usual(light.tightness >= 0.0);
    const Channels color = channels_of(light.color);
    for (std::size_t i = 0; i < 3; ++i) {
      diffuse_lights_[i] += std::abs(color[i]) * factor;
      if (!light.shadowless) shining_lights_[i] += std::abs(color[i]) * factor;
    }
  }
}

void Maker::look_at_matter(const Box3& origins) {
  const double around = scene_.settings.atmosphere_ior;
  const auto is_air = [around](const Interior& interior) {
    return std::abs(interior.ior / around - 1.0) < kNegligible && dispersion_of(interior) == 1.0;
  };
  matter_ = 0.0;
  for (const Interior& interior : scene_.interiors) {
    matter_ = std::max(matter_, std::abs(interior.refraction_scale));
    if (!is_air(interior)) bends_ = true;
    need(interior.caustics == 0.0);  // a feeler may gain at any number of surfaces
    if (std::abs(interior.fade_distance) <= kNegligible) continue;
    const Rgb& color = interior.fade_color;
    need(interior.fade_distance > 0.0 && std::min({color.x, color.y, color.z}) >= 0.0f && max_component(color) <= 1.0f);
  }
  // Both sides of each surface differ where all matter is of one kind, other than the air's, and every ray is bent.
  std::unordered_set<std::uint32_t> clear;
  for (const Part& part : scene_.parts) {
    if (!part.opaque) clear.insert(part.interior);
  }
  if (clear.size() != 1 || is_air(scene_.interiors[*clear.begin()])) return;
  goes_straight_ = std::ranges::any_of(scene_.solids, [&](const Solid& solid) {
    return !clear.contains(solid.matter) && may_hold_start(solid, origins);
  });
}

/// Diffuse light and highlights of all lights, and what shines by itself.
double Maker::lit(const Finish& finish, const PigmentLimits& pigment, std::size_t channel) {
  if (!scene_.settings.quality.has_light()) return pigment.color[channel].size();
  // A cosine to a power is at most 1, unless the power is negative.
  const auto largest_of = [&](double amount, double exponent) {
    return std::max(0.0, amount) * usual(amount <= 0.0 || exponent >= 0.0);
  };
  const double diffuse = largest_of(std::max(finish.diffuse, finish.diffuse_back), finish.brilliance);
  const double highlights =
      largest_of(finish.phong, finish.phong_size) + largest_of(finish.specular, finish.roughness_exponent);
  const double tint = finish.metallic > 0.0 ? largest_tint(finish.metallic, pigment.color[channel]) : 1.0;
  const double glow =
      std::abs(channels_of(finish.ambient)[channel] * channels_of(scene_.settings.ambient_light)[channel] +
               channels_of(finish.emission)[channel]);
  const double film = 1.0 + std::max(0.0, finish.irid);
  // Chance takes no less where little of the layer is left.
  const double chance = std::max(0.0, finish.crand) * pigment.color[channel].size();
  return pigment.body[channel] * (glow + film * diffuse * diffuse_lights_[channel]) +
         film * chance * diffuse_lights_[channel] + film * highlights * tint * shining_lights_[channel];
}

double Maker::mirror_of(const Finish& finish, const PigmentLimits& pigment) {
  double mirror = 0.0;
  const Channels least = channels_of(finish.reflection_min);
  const Channels most = channels_of(finish.reflection_max);
  for (std::size_t i = 0; i < 3; ++i) {
    mirror = std::max(mirror, std::max(std::abs(least[i]), std::abs(most[i])) *
                                  largest_tint(finish.reflection_metallic, pigment.color[i]));
  }
  mirror *= 1.0 + std::max(0.0, finish.irid);
  need(mirror == 0.0 || finish.reflection_fresnel || finish.reflection_falloff >= 0.0);
  return mirror;
}

void Maker::add(const Coat& coat) {
  SurfaceAnswer answer;
  Channels own{};
  double passed = 1.0;
  double most_kept = 1.0;       // of what passes, the rest being mirrored
  double kept_at_mirror = 1.0;  // where it mirrors most
  bool only_takes = true;
  for (const SurfaceLayer& layer : surfaces_.layers(coat)) {
    const Pigment& source = layer.source->pigment;
    const PigmentLimits pigment(source, scene_.settings.language_version, !scene_.settings.quality.has_pigments());
    need(pigment.is_known && !source.pattern->pigments);  // colours between those of several pigments are not looked at
    const Finish& finish = layer.source->finish;
    for (std::size_t i = 0; i < 3; ++i) own[i] += passed * most_kept * lit(finish, pigment, i);
    const double mirror = mirror_of(finish, pigment);
    if (finish.reflection_exponent == 1.0) {
      answer.mirrored += mirror;
    } else if (mirror > 0.0) {
      const double exponent = finish.reflection_exponent;
      const bool is_bounded = exponent >= 0.0 && exponent < INFINITY;
      need(is_bounded);
      const bool may_be_dark = exponent != std::floor(exponent) && has_negative_light();
      answer.sealed.push_back({mirror, is_bounded ? exponent : 1.0, may_be_dark});
    }
    passed *= pigment.most_passed();
    only_takes = only_takes && pigment.only_takes();
    if (!finish.conserve_energy) continue;
    const bool positive =
        std::min({finish.reflection_min.x, finish.reflection_min.y, finish.reflection_min.z, finish.reflection_max.x,
                  finish.reflection_max.y, finish.reflection_max.z}) >= 0.0f &&
        finish.reflection_metallic >= 0.0 && finish.reflection_metallic <= 1.0 && !pigment.has_negative_color();
    most_kept *= std::max(1.0, std::abs(1.0 - mirror));
    // Light that is both mirrored and passed on is largest at one end of what the mirror may be.
    kept_at_mirror *= coat.count == 1 && positive ? std::abs(1.0 - mirror) : std::max(1.0, std::abs(1.0 - mirror));
  }
  answer.own = largest(own);
  need(only_takes || coat.is_opaque);  // a feeler may cross any number of surfaces
  if (passed * most_kept * (1.0 + PigmentLimits::kBlendError) <=
      scene_.settings.adc_bailout) {  // no ray is sent through
    keep(answer);
    return;
  }
  const auto add_passing = [&](SurfaceAnswer with, double share) {
    with.straight = goes_straight_ ? share : 0.0;
    with.bent = bends_ ? share : 0.0;
    keep(with);
  };
  add_passing(answer, passed * kept_at_mirror * matter_);
  SurfaceAnswer unmirrored;
  unmirrored.own = answer.own;
  if (kept_at_mirror < most_kept) add_passing(unmirrored, passed * most_kept * matter_);
  if (bends_) {  // total reflection, which mirrors nothing beside
    unmirrored.bent = matter_;
    keep(unmirrored);
  }
}

}  // namespace

double SurfaceAnswer::from_this_side(double incoming) const {
  double light = own + mirrored * incoming;
  for (const Power& power : sealed) {
    light += power.factor * std::max(steady::power(incoming, power.exponent), power.may_be_dark ? kDarkness : 0.0);
  }
  return light;
}

SurfaceLimits::SurfaceLimits(const Scene& scene, const SurfaceTable& surfaces, const Box3& origins) {
  background = sky_limit(scene, proven);
  veil = veil_limits(scene, proven);
  Maker maker(scene, surfaces, origins, *this);
  // Between several coats there is no more than the one that is most.
  for (const Coat& coat : surfaces.coats()) maker.add(coat);
}

}  // namespace firstlight::render
