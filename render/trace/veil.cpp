#include "render/trace/veil.h"

#include "render/lanes/math.h"
#include "render/math/point_hash.h"
#include "render/trace/fog_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

}  // namespace

Veils::Veils(const Scene& scene) : noise_generator_(scene.settings.noise_generator) {
  for (const Fog& fog : scene.atmosphere.fogs) {
    if (std::abs(fog.distance) > kNegligible) fogs_.push_back(&fog);
  }
  for (const Rainbow& rainbow : scene.atmosphere.rainbows) {
    if (!rainbow.shows()) continue;
    constexpr double kRadian = std::numbers::pi / 180.0;
    Bow& bow = bows_.emplace_back();
    bow.source = &rainbow;
    bow.right = rainbow.up.cross(rainbow.direction).normalized();
    bow.inner = (rainbow.angle - 0.5 * rainbow.width) * kRadian;
    bow.width = rainbow.width * kRadian;
    bow.fading = rainbow.arc_half_angle - rainbow.falloff_half_angle;
    auto pigment = std::make_unique<Pigment>();
    PigmentPattern& pattern = pigment->pattern.change();
    static_cast<Patterning&>(pattern) = patterned(PatternKind::gradient, GradientParameters{{1.0, 0.0, 0.0}});
    pattern.map = rainbow.colors;
    bow.pigment = std::move(pigment);
    bow.colors = std::make_unique<const CompiledPigment>(*bow.pigment, PatternWorld{});
  }
}

void Veils::across(std::uint64_t who, std::size_t count, const RayColumns& rays, const Column<double>& depth,
                   std::span<Veil> veils) const {
  for (std::size_t i = 0; i < count; ++i) {
    veils[i] = (who >> i & 1u) != 0 && !bows_.empty() ? bows(rays.ray(i), depth[i]) : Veil();
  }
  if (fogs_.empty() || who == 0) return;
  std::array<Veil, kRaysAtOnce> in_fog;
  Column<double> share;
  for (const Fog* fog : fogs_) {
    find_fog_shares(*fog, noise_generator_, count, rays.origin, rays.direction, depth, share);
    for (std::size_t i = 0; i < count; ++i) add_fog(*fog, share[i], in_fog[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if ((who >> i & 1u) == 0) continue;
    veils[i] = {in_fog[i].kept * veils[i].kept, in_fog[i].added + in_fog[i].kept * veils[i].added,
                grey(in_fog[i].kept) * veils[i].clear};
  }
}

Rgb Veils::left_of_light(const Ray& ray, double depth) const {
  Veil veil;
  for (const Fog* fog : fogs_) add_fog(*fog, fog_share(*fog, noise_generator_, ray, depth), veil);
  return veil.kept;
}

/// `share`: of the light that the fog leaves.
void Veils::add_fog(const Fog& fog, double share, Veil& veil) {
  const FilteredColor& color = fog.color;
  const auto left = static_cast<float>(std::max(share, static_cast<double>(color.transmit)));
  veil.kept *= (Rgb(1.0f - color.filter) + color.rgb * color.filter) * left;
  veil.added += color.rgb * (1.0f - left);
}

Veil Veils::bows(const Ray& ray, double depth) const {
  Veil sum{Rgb(0.0f), Rgb(0.0f)};
  float count = 0.0f;
  for (std::size_t i = 0; i < bows_.size(); ++i) {
    const std::optional<Veil> veil = bow(bows_[i], ray, depth, i);
    if (!veil) continue;
    sum.kept += veil->kept;
    sum.added += veil->added;
    sum.clear *= veil->clear;
    count += 1.0f;
  }
  if (count == 0.0f) return {};
  return {sum.kept / count, sum.added / count, sum.clear};
}

std::optional<Veil> Veils::bow(const Bow& bow, const Ray& ray, double depth, std::uint64_t number) const {
  const Rainbow& rainbow = *bow.source;
  const double across = ray.direction.dot(bow.right);
  double up = ray.direction.dot(rainbow.up);
  const double length2 = across * across + up * up;
  if (length2 > 0.0) up /= std::sqrt(length2);
  const double from_top = std::abs(steady::arc_cosine(up));
  const double along = ray.direction.dot(rainbow.direction);
  // Not a number is outside, of both.
  if (!(from_top <= rainbow.arc_half_angle) || !(along >= 0.0)) return std::nullopt;

  double place = (steady::arc_cosine(along) - bow.inner) / bow.width;
  if (rainbow.jitter > 0.0) place += (2.0 * hashed_number(ray.direction, number) - 1.0) * rainbow.jitter;
  if (!(place >= 0.0 && place <= 1.0 - kNegligible)) return std::nullopt;
  const FilteredColor color = bow.colors->color_at({place, 0.0, 0.0});

  double fade = 0.0;
  if (bow.fading > 0.0 && from_top > rainbow.falloff_half_angle) {
    const double t = (from_top - rainbow.falloff_half_angle) / bow.fading;
    fade = (3.0 - 2.0 * t) * t * t;
  }
  const double transmit = color.transmit;
  const double left = std::max(steady::exponential(-depth / rainbow.distance), fade * (1.0 - transmit) + transmit);
  const double taken = 1.0 - left;
  const auto filter = static_cast<float>(static_cast<double>(color.filter) * taken);
  return Veil{(Rgb(1.0f - filter) + color.rgb * filter) * static_cast<float>(left),
              color.rgb * static_cast<float>(taken), static_cast<float>(left * transmit)};
}

bool is_hollow(const Scene& scene, MediumTable& media, std::uint32_t medium) {
  while (!media.is_outside(medium)) {
    const std::uint32_t interior = media.innermost(medium);
    if (!scene.interiors[interior]->hollow) return false;
    medium = media.left(medium, interior);
  }
  return true;
}

}  // namespace firstlight::render
