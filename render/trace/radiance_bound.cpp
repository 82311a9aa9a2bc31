#include "render/trace/radiance_bound.h"

#include "render/math/fixed_rgb.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

/// What a surface may do at most to light of any channel.
struct Limits {
  double own = 0.0;         ///< own light and the lights'
  double reflected = 0.0;   ///< share of what comes from where it mirrors
  double straight = 0.0;    ///< share of what comes from behind, with no bend
  double bent = 0.0;        ///< the same with a bend; everything at a total reflection
  double sealed = 0.0;      ///< factor on what is mirrored, to the power below
  double exponent = 1.0;
};

double largest(const Rgb& color) { return static_cast<double>(max_magnitude(color)); }

/// Largest values over all colours that a pigment can take: between two colours of a map lies nothing larger.
struct PigmentLimits {
  double color = 0.0;
  double opacity = 0.0;
  double passed = 0.0;

  explicit PigmentLimits(const Pigment& pigment) {
    const auto include = [this](const FilteredColor& c) {
      color = std::max(color, largest(c.rgb));
      opacity = std::max({opacity, std::abs(1.0 - c.filter - c.transmit),
                          std::abs(1.0 - (c.filter * largest(c.rgb) + c.transmit))});
      passed = std::max(passed, largest(c.rgb) * std::abs(c.filter) + std::abs(c.transmit));
    };
    if (!pigment.pattern) {
      include(pigment.color);
    } else if (pigment.map.empty()) {
      include({});
    } else {
      for (const ColorMapEntry& entry : pigment.map) include(entry.color);
    }
  }
};

/// Factor of metallic_tint(): between 1 and the surface's colour, or beyond it for more than metal.
double largest_tint(double metallic, double color) {
  if (metallic <= 0.0) return 1.0;
  return metallic <= 1.0 ? std::max(1.0, color) : 1.0 + (color + 1.0) * metallic;
}

double all_lights(const Scene& scene) {
  double sum = 0.0;
  for (const Light& light : scene.lights) sum += largest(light.color) * (light.fade_power > 0.0 ? 2.0 : 1.0);
  return sum;
}

/// What is left of light after some matter: more than all of it only in matter that adds.
double most_after_matter(const Scene& scene) {
  double most = 1.0;
  for (const Interior& interior : scene.interiors) {
    const double fade = interior.fade_power > 0.0 ? std::max(1.0, largest(interior.fade_color)) : 1.0;
    most = std::max(most, fade * std::abs(interior.refraction_scale));
  }
  return most;
}

Limits limits_of(const Texture& texture, const Scene& scene, double lights, double matter) {
  Limits limits;
  double filter = 1.0;
  for (const TextureLayer& layer : texture.layers) {
    const PigmentLimits pigment(layer.pigment);
    const Finish& finish = layer.finish;
    const double tint = largest_tint(finish.metallic, pigment.color);
    const double ambient = largest(finish.ambient) * largest(scene.settings.ambient_light) + largest(finish.emission);
    const double diffuse = std::max(std::abs(finish.diffuse), std::abs(finish.diffuse_back));
    const double highlights = (std::abs(finish.phong) + std::abs(finish.specular)) * tint;
    limits.own += filter * (pigment.color * pigment.opacity * (ambient + diffuse * lights) + highlights * lights);
    double mirror = std::max(largest(finish.reflection_min), largest(finish.reflection_max)) *
                    largest_tint(finish.reflection_metallic, pigment.color);
    if (mirror > 0.0 && finish.reflection_falloff < 0.0) mirror = INFINITY;
    if (finish.reflection_exponent == 1.0) {
      limits.reflected += filter * mirror;
    } else {
      limits.sealed += filter * mirror;
      limits.exponent = std::max(limits.exponent, finish.reflection_exponent);
    }
    filter *= pigment.passed;
    if (finish.conserve_energy) filter *= std::max(1.0, std::abs(1.0 - mirror));
  }
  if (filter > 0.0) {
    limits.straight = filter * matter;
    limits.bent = std::max(filter, 1.0) * matter;
  }
  return limits;
}

}  // namespace

RadianceBound::RadianceBound(const Scene& scene) {
  // Sums of many bounds must stay within 64 bits.
  constexpr double kLargest = 65536.0;
  constexpr double kNearlyAll = 0.95;  // for the guess where rows of clear surfaces have no bound
  const double lights = all_lights(scene);
  const double matter = most_after_matter(scene);
  std::vector<Limits> surfaces;
  surfaces.reserve(scene.textures.size());
  for (const PlacedTexture& placed : scene.textures) {
    Limits limits = limits_of(*placed.texture, scene, lights, matter);
    if (limits.straight >= 1.0) {
      known_ = false;
      limits.straight = kNearlyAll;
    }
    surfaces.push_back(limits);
  }
  // A ray goes straight on without rising in level, so that U(l) = own + r U(l+1) + s U(l).
  const int levels = scene.settings.max_trace_level;
  most_.assign(static_cast<std::size_t>(std::max(levels, 255)) + 1, 0.0f);
  double next = 0.0;
  for (int level = levels - 1; level >= 0; --level) {
    double most = std::max(next, largest(scene.settings.background));
    for (const Limits& surface : surfaces) {
      const double mirrored = surface.own + surface.reflected * next +
                              (surface.sealed > 0.0 ? surface.sealed * std::max(1.0, std::pow(next, surface.exponent)) : 0.0);
      most = std::max({most, mirrored / (1.0 - surface.straight), mirrored + surface.bent * next});
    }
    if (!(most <= kLargest)) {
      known_ = false;
      most = kLargest;
    }
    next = most;
    // A little more than computed: roundings on the way of a ray must not exceed it.
    most_[static_cast<std::size_t>(level)] = static_cast<float>(most * (1.0 + 1e-4));
  }
}

std::int64_t RadianceBound::at_stake(const RayTask& task) const {
  if (task.kind == RayKind::shadow) {
    std::int64_t sum = 1;
    task.for_each_feeler(
        [&](std::uint32_t, const PackedRgb& light) { sum += FixedRgb::from(light).max_magnitude(); });
    return sum;
  }
  const bool continued = (task.flags & RayTask::kContinued) != 0;
  const float most = this->most(continued && task.level > 0 ? task.level - 1 : task.level);
  return 1 + FixedRgb::from(Rgb(max_magnitude(task.radiance.weight()) * most)).r;
}

}  // namespace firstlight::render
