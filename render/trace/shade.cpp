// Lights on what rays have met, as if nothing were in their way, and the rays that the surfaces send on.

#include "render/lanes/math.h"
#include "render/math/interrupt.h"
#include "render/trace/fade.h"
#include "render/trace/film_thickness.h"
#include "render/trace/step.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

/// Where some hits are tilted in a layer, the others have their own normal there.
void complete_normals(HitBlock& block) {
  for (LayerColumns& layer : std::span(block.layers).first(block.layer_count)) {
    if (layer.tilted == 0) continue;
    for (std::size_t i = 0; i < block.size; ++i) {
      if ((layer.tilted >> i & 1u) == 0) layer.normal.set(i, block.normal.vector(i));
    }
  }
}

}  // namespace

// In place: a record that is put together elsewhere and copied in wider pieces waits for its own parts.
inline void Stepper::begin_child(RayTask& child, std::size_t hit, RayKind kind) const {
  const Surface& surface = surfaces_[hit];
  child.origin = block_->point.vector(hit);
  child.sample = surface.task->sample;
  child.medium = surface.task->medium;
  child.kind = kind;
  child.level = static_cast<std::uint8_t>(std::min(surface.level, 255));
  child.flags = surface.task->flags & RayTask::kReflected;
  child.object = static_cast<std::uint16_t>(std::min<std::uint32_t>(surface.part->object, RayTask::kNoObject));
}

inline void Stepper::end_ray(const Surface& surface) {
  const RayTask& ray = spawned_.back();
  if (ray.is_black() || !is_worth_tracing(context_.scene.settings, ray)) {
    spawned_.pop_back();
  } else {
    surface.sum->outstanding += bound_.at_stake(ray);
  }
}

void Stepper::shade() {
  HitBlock& block = *block_;
  complete_normals(block);
  for (std::size_t i = 0; i < block.size; ++i) block.own_light.set(i, surfaces_[i].own_light);
  begin_light(block);
  if (block.layer_count > 0) {
    const std::span<const Light> lights = context_.scene.lights;
    const bool from_behind = block.lit_from_behind || has_two_sided_light_;
    const FeelerStarts starts{block.point, block.normal, block.size, from_behind};
    for (std::size_t first = 0; first < lights.size() && !Interrupt::asked(); first += kLightsAtOnce) {
      const std::size_t count = std::min(kLightsAtOnce, lights.size() - first);
      if (has_light_groups_) find_reached(lights.subspan(first, count));
      context_.accel.foresee(starts, first, lights.subspan(first, count), block.foreseen);
      for (std::size_t l = 0; l < count; ++l) {
        if (veils_of_scene_.weaken(lights[first + l])) block.foreseen[l].clear = 0;
      }
      block.first_light = first;
      light_hits(block, lights.subspan(first, count));
      spawn_feelers(static_cast<std::uint32_t>(first), count);
    }
  }
  counts_.of(RayKind::shadow) += block.clear_feelers + block.blocked_feelers;
  counts_.clear += block.clear_feelers;
  counts_.blocked += block.blocked_feelers;
  const Settings& settings = context_.scene.settings;
  for (std::size_t i = 0; i < block.size; ++i) {
    surfaces_[i].sum->light += {block.sum.of[0][i], block.sum.of[1][i], block.sum.of[2][i]};
  }
  for (const Coating& coating : coatings_) {
    if (surfaces_[coating.hit].level >= settings.max_trace_level) continue;
    const bool passes = settings.quality.has_refraction() && coating.share > settings.adc_bailout;
    const bool reflects_all = passes && spawn_transmission(coating);
    if (settings.quality.has_reflection()) spawn_reflections(coating, reflects_all);
  }
}

void Stepper::find_reached(std::span<const Light> lights) {
  for (std::size_t l = 0; l < lights.size(); ++l) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < block_->size; ++i) {
      bits |= static_cast<std::uint64_t>(shines_on(lights[l], *surfaces_[i].part)) << i;
    }
    block_->reached[l] = bits;
  }
}

void Stepper::spawn_feelers(std::uint32_t first_light, std::size_t light_count) {
  std::uint64_t hits = 0;
  for (std::size_t l = 0; l < light_count; ++l) hits |= block_->open[l];
  for (; hits != 0; hits &= hits - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(hits));
    std::uint32_t which = 0;
    for (std::size_t l = 0; l < light_count; ++l) which |= static_cast<std::uint32_t>(block_->open[l] >> i & 1u) << l;
    Surface& surface = surfaces_[i];
    const auto held = [&](std::uint32_t light) { return PackedRgb::from_bits(block_->light[light][i]); };
    const int count = std::popcount(which);
    if (count > static_cast<int>(RayTask::kMostFeelers) || surface.open_record != kNoRecord) {
      for (; which != 0; which &= which - 1) {
        const auto light = static_cast<std::uint32_t>(std::countr_zero(which));
        add_feeler(i, first_light + light, held(light));
      }
      continue;
    }
    surface.open_record = spawned_.size();
    RayTask& record = spawned_.emplace_back();
    begin_child(record, i, RayKind::shadow);
    const auto first = static_cast<std::uint32_t>(std::countr_zero(which));
    record.set_feeler(first_light + first, held(first));
    if (count == 2) {
      const auto second = static_cast<std::uint32_t>(std::bit_width(which)) - 1;
      record.add_feeler(first_light + second, held(second));
    }
    surface.sum->outstanding += block_->at_stake[i];
  }
}

void Stepper::add_feeler(std::size_t hit, std::uint32_t light, PackedRgb at_stake) {
  Surface& surface = surfaces_[hit];
  if (surface.open_record != kNoRecord) {
    RayTask& record = spawned_[surface.open_record];
    const std::int64_t before = bound_.at_stake(record);
    if (record.add_feeler(light, at_stake)) {
      surface.sum->outstanding += bound_.at_stake(record) - before;
      return;
    }
  }
  surface.open_record = spawned_.size();
  RayTask& record = spawned_.emplace_back();
  begin_child(record, hit, RayKind::shadow);
  record.set_feeler(light, at_stake);
  surface.sum->outstanding += bound_.at_stake(record);
}

Vec3 Stepper::normal_at(std::size_t hit, std::uint32_t column) const {
  return is_tilted(hit, column) ? block_->layers[column].normal.vector(hit) : block_->normal.vector(hit);
}

// A ray that a tilted normal would send below the surface is turned up again. [POV-Ray 3.7]
Vec3 Stepper::reflected_by(std::size_t hit, const Vec3& normal) const {
  const Vec3 direction = block_->direction.vector(hit);
  const Vec3 bare = block_->normal.vector(hit);
  Vec3 reflected = direction - normal * (2.0 * direction.dot(normal));
  const double above = reflected.dot(bare);
  if (above < 0.0) {
    reflected =
        reflected.dot(normal) < 0.0 ? direction - bare * (2.0 * direction.dot(bare)) : reflected - bare * (2.0 * above);
  }
  return reflected.normalized();
}

/// As film_tint() in light_block.cpp, of light that is mirrored.
Rgb Stepper::film_color(std::size_t hit, const Mirror& mirror, PackedDirection reflected) const {
  const Settings& settings = context_.scene.settings;
  const Vec3 normal = normal_at(hit, mirror.column);
  const double film =
      film_thickness(*mirror.layer->source->finish, block_->point.vector(hit), settings.noise_generator);
  const double cosines = std::abs(normal.dot(reflected.unpack())) + std::abs(normal.dot(block_->direction.vector(hit)));
  const double way = 2.0 * std::numbers::pi * film * cosines;
  const auto channel = [&](float wavelength) {
    return static_cast<float>(1.0 + mirror.layer->irid * steady::cosine(way / static_cast<double>(wavelength)));
  };
  const Rgb& lengths = settings.irid_wavelength;
  return {channel(lengths.x), channel(lengths.y), channel(lengths.z)};
}

void Stepper::spawn_reflections(const Coating& coating, bool totally) {
  const Surface& surface = surfaces_[coating.hit];
  for (const Mirror& mirror : std::span(mirrors_).subspan(coating.first_mirror, coating.mirror_count)) {
    if (is_black(mirror.reflection)) continue;
    if (totally) {
      const Vec3 gap = normal_at(coating.hit, coating.column) - normal_at(coating.hit, mirror.column);
      if (std::max({std::abs(gap.x), std::abs(gap.y), std::abs(gap.z)}) <= kNegligible) continue;
    }
    RayTask& child = spawned_.emplace_back();
    begin_child(child, coating.hit, RayKind::reflection);
    child.set_direction(is_tilted(coating.hit, mirror.column)
                            ? PackedDirection(reflected_by(coating.hit, normal_at(coating.hit, mirror.column)))
                            : std::bit_cast<PackedDirection>(block_->mirrored[coating.hit]));
    Rgb weight = coating.weight * mirror.reflection;
    if (mirror.layer->irid != 0.0) weight *= film_color(coating.hit, mirror, child.direction());
    child.set_weight(weight, static_cast<float>(mirror.adc_weight));
    child.flags |= RayTask::kReflected;
    const double exponent = mirror.layer->source->finish->reflection_exponent;
    if (exponent == 1.0) {
      end_ray(surface);
      continue;
    }
    const RayTask root = child;
    spawned_.pop_back();
    if (!root.is_black() && is_worth_tracing(context_.scene.settings, root)) add_sealed(surface, root, exponent);
  }
}

// Nested matter counts as outside of what surrounds it; of overlapping matter, the one met last fills the overlap.
// [POV-Ray 3.7]
Stepper::Passage Stepper::passage_of(const Surface& surface) const {
  const Scene& scene = context_.scene;
  MediumTable& media = context_.media;
  const std::uint32_t own = surface.part->interior;
  const std::uint32_t around = surface.task->medium;
  const auto innermost = [&](std::uint32_t medium) {  // null: the air
    return media.is_outside(medium) ? nullptr : &*scene.interiors[media.innermost(medium)];
  };
  const auto between = [&](const Interior* from, const Interior* to, std::uint32_t medium, int bands) {
    const auto ior = [&](const Interior* matter) { return matter ? matter->ior : scene.settings.atmosphere_ior; };
    const auto dispersion = [](const Interior* matter) { return matter ? dispersion_of(*matter) : 1.0; };
    return Passage{medium, ior(from) / ior(to), dispersion(from) / dispersion(to), bands};
  };
  const Interior& interior = scene.interiors[own];
  if (!media.contains(around, own)) {
    return between(innermost(around), &interior, media.entered(around, own), interior.dispersion_samples);
  }
  const std::uint32_t beyond = media.left(around, own);
  if (media.innermost(around) != own) return {beyond, 1.0, 1.0, 0};
  const Interior* const next = innermost(beyond);
  const int bands = std::max(interior.dispersion_samples, next != nullptr ? next->dispersion_samples : 0);
  return between(&interior, next, beyond, bands);
}

bool Stepper::bend(const Coating& coating, double ior, RayTask& child) const {
  // Heckbert's form of Snell's law: T = ior I + (ior c - sqrt(1 + ior^2 (c^2 - 1))) N, N towards the ray's origin.
  const std::size_t hit = coating.hit;
  const Vec3 direction = block_->direction.vector(hit);
  const Vec3 normal = normal_at(hit, coating.column);
  const double along = -direction.dot(normal);
  const Vec3 facing = along >= 0.0 ? normal : -normal;
  const double cosine = std::abs(along);
  const double root = 1.0 + ior * ior * (cosine * cosine - 1.0);
  if (root < 0.0) {
    child.kind = RayKind::reflection;
    child.flags |= RayTask::kReflected;
    child.medium = surfaces_[hit].task->medium;
    child.set_direction(PackedDirection(is_tilted(hit, coating.column) ? reflected_by(hit, normal)
                                                                       : direction + normal * (2.0 * cosine)));
    return true;
  }
  child.set_direction(PackedDirection(direction * ior + facing * (ior * cosine - std::sqrt(root))));
  return false;
}

bool Stepper::spawn_transmission(const Coating& coating) {
  const std::size_t hit = coating.hit;
  const Surface& surface = surfaces_[hit];
  const std::uint32_t own = surface.part->interior;
  const std::uint32_t around = surface.task->medium;
  const Interior& interior = context_.scene.interiors[own];
  const Passage passage = passage_of(surface);

  Rgb passed = Rgb(static_cast<float>(interior.refraction_scale));
  if (std::abs(interior.fade_distance) > kNegligible && context_.media.contains(around, own)) {
    passed *= faded_light(interior, block_->crossing[hit]->depth);
  }
  const Rgb weight = coating.weight * passed;
  const bool disperses = std::abs(passage.dispersion - 1.0) >= kNegligible;
  const SpectralBand band = disperses ? context_.media.band(around) : SpectralBand();
  if (disperses && band.is_white()) {
    spawn_bands(coating, passage, weight * coating.filter);
    return false;
  }
  RayTask& child = spawned_.emplace_back();
  begin_child(child, hit, RayKind::transmission);
  child.medium = passage.medium;
  bool totally_reflected = false;
  if (std::abs(passage.ior - 1.0) < kNegligible && !disperses) {
    child.set_direction(PackedDirection(block_->direction.vector(hit)));
    child.flags |= RayTask::kContinued;
  } else {
    const double ior = disperses ? dispersed_ior(passage.ior, passage.dispersion, band) : passage.ior;
    totally_reflected = bend(coating, ior, child);
  }
  child.set_weight(totally_reflected ? weight : weight * coating.filter,
                   surface.task->adc_weight() * max_magnitude(coating.filter));
  const float clear = totally_reflected ? 0.0f : coating.clear * grey(passed) * static_cast<float>(coating.share);
  if (clear != 0.0f) {
    RayTask seeing_through = child;
    seeing_through.flags |= RayTask::kSeesThrough;
    seeing_through.set_weight(Rgb(clear), child.adc_weight());
    end_ray(surface);
    spawned_.push_back(seeing_through);
  }
  end_ray(surface);
  return totally_reflected;
}

// Bands that are totally reflected go one way together, and as white light, which may be split again. [POV-Ray 3.7]
void Stepper::spawn_bands(const Coating& coating, const Passage& passage, const Rgb& weight) {
  const Surface& surface = surfaces_[coating.hit];
  const float adc_weight = surface.task->adc_weight() * max_magnitude(coating.filter);
  Rgb reflected(0.0f);
  double reflected_ior = 0.0;
  for (int number = 0; number < passage.bands; ++number) {
    const SpectralBand band{static_cast<std::uint16_t>(number), static_cast<std::uint16_t>(passage.bands)};
    const Rgb share = hue(band) / static_cast<float>(passage.bands);
    const double ior = dispersed_ior(passage.ior, passage.dispersion, band);
    RayTask& child = spawned_.emplace_back();
    begin_child(child, coating.hit, RayKind::transmission);
    child.medium = context_.media.in_band(passage.medium, band);
    if (bend(coating, ior, child)) {
      reflected += share;
      reflected_ior = ior;
      spawned_.pop_back();
      continue;
    }
    child.set_weight(weight * share, adc_weight);
    end_ray(surface);
  }
  if (is_black(reflected)) return;
  RayTask& child = spawned_.emplace_back();
  begin_child(child, coating.hit, RayKind::reflection);
  bend(coating, reflected_ior, child);
  child.set_weight(weight * reflected, adc_weight);
  end_ray(surface);
}

}  // namespace firstlight::render
