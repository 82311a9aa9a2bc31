#include "render/trace/veil.h"

#include "render/lanes/math.h"
#include "render/math/noise.h"
#include "render/math/point_hash.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

double turbulence_at(const Fog& fog, const Vec3& point, int generator) {
  const FogTurbulence& turbulent = *fog.turbulence;
  const Octaves octaves{turbulent.octaves, static_cast<float>(turbulent.lambda), static_cast<float>(turbulent.omega)};
  return turbulence(point * turbulent.amount, octaves, generator);
}

/// Mean density of ground fog between two heights, in units of `altitude` above `offset`: it is 1 below 0 and 1/(1+y^2)
/// above, whose integral is atan(y).
double mean_density(double start, double end) {
  if (start <= 0.0 && end <= 0.0) return 1.0;
  if (start <= 0.0) return (steady::arc_tangent(end) - start) / (end - start);
  if (end <= 0.0) return (steady::arc_tangent(start) - end) / (start - end);
  const double rise = start - end;
  if (std::abs(rise) > kNegligible) return (steady::arc_tangent(start) - steady::arc_tangent(end)) / rise;
  return 1.0 / (start * start + 1.0);
}

/// Share of the light that is left after a way through the fog.
double left_by(const Fog& fog, const Ray& ray, double depth, int generator) {
  const Vec3 end = ray.origin + ray.direction * depth;
  double density = 1.0;
  if (fog.type == Fog::kGround) {
    density = mean_density((ray.origin.dot(fog.up) - fog.offset) / fog.altitude,
                           (end.dot(fog.up) - fog.offset) / fog.altitude);
  }
  double way = depth;
  if (fog.turbulence) {
    const Vec3 middle = fog.type == Fog::kGround ? (ray.origin + end) * 0.5 : ray.origin + ray.direction * (depth / 2.0);
    // The longer the way, the more of the turbulence evens out.
    const double evenness = steady::exponential(-depth / fog.distance);
    way *= 1.0 - evenness * std::min(1.0, turbulence_at(fog, middle, generator) * fog.turbulence_depth);
  }
  return steady::exponential(-way * density / fog.distance);
}

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

Veil Veils::across(const Ray& ray, double depth) const {
  Veil veil;
  if (!bows_.empty()) veil = bows(ray, depth);
  if (!fogs_.empty()) add_fogs(ray, depth, veil);
  return veil;
}

Rgb Veils::left_of_light(const Ray& ray, double depth) const {
  Veil veil;
  add_fogs(ray, depth, veil);
  return veil.kept;
}

void Veils::add_fogs(const Ray& ray, double depth, Veil& veil) const {
  Rgb kept(1.0f);
  Rgb added(0.0f);
  for (const Fog* fog : fogs_) {
    const FilteredColor& color = fog->color;
    const auto left = static_cast<float>(
        std::max(left_by(*fog, ray, depth, noise_generator_), static_cast<double>(color.transmit)));
    kept *= (Rgb(1.0f - color.filter) + color.rgb * color.filter) * left;
    added += color.rgb * (1.0f - left);
  }
  veil = {kept * veil.kept, added + kept * veil.added};
}

Veil Veils::bows(const Ray& ray, double depth) const {
  Veil sum{Rgb(0.0f), Rgb(0.0f)};
  float count = 0.0f;
  for (std::size_t i = 0; i < bows_.size(); ++i) {
    const std::optional<Veil> veil = bow(bows_[i], ray, depth, i);
    if (!veil) continue;
    sum.kept += veil->kept;
    sum.added += veil->added;
    count += 1.0f;
  }
  if (count == 0.0f) return {};
  return {sum.kept / count, sum.added / count};
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
              color.rgb * static_cast<float>(taken)};
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
