// The surfaces that rays meet: their own light, lights as if unoccluded, and the rays they send on.

#include "render/trace/fade.h"
#include "render/trace/local_light.h"
#include "render/trace/step.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

/// Of a layer for hits that have none. The share too, for what was there before need not be a number.
void clear_amounts(LayerColumns& layer, std::size_t count) {
  for (Column<double>& column : layer.share.of) std::fill_n(column.at.begin(), count, 0.0);
  for (Column<double>* column : {&layer.diffuse, &layer.diffuse_back, &layer.phong, &layer.specular}) {
    std::fill_n(column->at.begin(), count, 0.0);
  }
}

double positive(double amount) { return amount > 0.0 ? amount : 0.0; }

std::uint32_t mixed(std::uint32_t path, std::uint32_t branch) {
  std::uint32_t h = path * 0x9e3779b1u + branch + 1u;
  h ^= h >> 15;
  h *= 0x85ebca77u;
  return h ^ (h >> 13);
}

}  // namespace

void Stepper::meet(const RayTask& task, const Ray& ray, const Hit& hit, Contribution& sum) {
  const Scene& scene = context_.scene;
  const Part& part = scene.parts[hit.part];
  const Vec3 point = ray.at(hit.depth);
  Vec3 normal = hit.shape->normal(point, {hit.depth, hit.shape, hit.part, hit.face});
  const bool from_inside = normal.dot(ray.direction) > 0.0;
  if (from_inside) normal = -normal;
  const std::uint32_t texture = from_inside && part.interior_texture != kNoIndex ? part.interior_texture : part.texture;
  if (texture == kNoIndex) return;

  const bool continued = (task.flags & RayTask::kContinued) != 0;
  HitBlock& block = *block_;
  const std::size_t i = block.size++;
  block.point.set(i, point);
  block.direction.set(i, ray.direction);
  block.normal.set(i, normal);
  block.lit_from[i] = part.double_illuminate ? -2.0 : kNegligible;
  Surface& surface = surfaces_.emplace_back(Surface{.task = &task,
                                                    .part = &part,
                                                    .sum = &sum,
                                                    .direction = ray.direction,
                                                    .point = point,
                                                    .normal = normal,
                                                    .depth = hit.depth,
                                                    .level = task.level + (continued ? 0 : 1),
                                                    .filter = Rgb(1.0f),
                                                    .first_layer = layers_.size(),
                                                    .layer_count = 0,
                                                    .open_record = kNoRecord});
  meet_layers(surface, scene.textures[texture]);
}

void Stepper::meet_layers(Surface& surface, const PlacedTexture& texture) {
  const Settings& settings = context_.scene.settings;
  const Vec3 local = texture.to_texture.is_identity() ? surface.point : texture.to_texture.point(surface.point);
  HitBlock& block = *block_;
  const std::size_t hit = block.size - 1;
  const Rgb weight = surface.task->radiance.weight();
  Rgb filter(1.0f);
  double share = 1.0;
  Rgb own_light(0.0f);
  for (const TextureLayer& layer : texture.texture->layers) {
    if (share <= settings.adc_bailout) break;
    const FilteredColor pigment = color_at(layer.pigment, local);
    const Finish& finish = layer.finish;
    // Before 3.7 a tinted layer kept more of its own light. [POV-Ray 3.7: language version below 370]
    const double opacity = settings.language_version < 370
                               ? 1.0 - (pigment.filter * max_component(pigment.rgb) + pigment.transmit)
                               : 1.0 - pigment.filter - pigment.transmit;
    const std::size_t k = surface.layer_count++;
    if (k == block.layer_count) {
      if (k == block.layers.size()) block.layers.emplace_back();
      clear_amounts(block.layers[k], block.capacity);
      ++block.layer_count;
    }
    LayerColumns& columns = block.layers[k];
    columns.color.set(hit, pigment.rgb);
    columns.share.set(hit, weight * filter);
    columns.diffuse[hit] = positive(finish.diffuse) * opacity;
    columns.diffuse_back[hit] = positive(finish.diffuse_back) * opacity;
    block.lit_from_behind |= finish.diffuse_back != 0.0;
    columns.brilliance[hit] = finish.brilliance;
    columns.phong[hit] = finish.phong;
    columns.phong_size[hit] = finish.phong_size;
    columns.specular[hit] = finish.specular;
    columns.specular_exponent[hit] = finish.roughness_exponent;
    columns.metallic[hit] = finish.metallic;

    Layer& shaded = layers_.emplace_back(Layer{&finish, Rgb(0.0f), surface.task->radiance.adc_weight * share});
    shaded.reflection = reflectivity(surface, finish, pigment.rgb, shaded.adc_weight);
    own_light += filter * pigment.rgb * (finish.ambient * settings.ambient_light + finish.emission) *
                 static_cast<float>(opacity);
    filter *= pigment.passed();
    if (finish.conserve_energy) {
      const Rgb kept = Rgb(1.0f) - shaded.reflection;
      filter *= Rgb(std::min(1.0f, kept.x), std::min(1.0f, kept.y), std::min(1.0f, kept.z));
    }
    share = std::min(1.0, static_cast<double>(std::abs(grey(filter))));
  }
  surface.filter = filter;
  block.own_light.set(hit, weight * own_light);
}

void Stepper::shade() {
  HitBlock& block = *block_;
  begin_light(block);
  if (block.layer_count > 0) {
    const std::span<const Light> lights = context_.scene.lights;
    for (std::size_t first = 0; first < lights.size(); first += kLightsAtOnce) {
      const std::size_t count = std::min(kLightsAtOnce, lights.size() - first);
      light_hits(block, lights.subspan(first, count));
      spawn_feelers(static_cast<std::uint32_t>(first), count);
    }
  }
  const Settings& settings = context_.scene.settings;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const Surface& surface = surfaces_[i];
    surface.sum->light += {block.sum.of[0][i], block.sum.of[1][i], block.sum.of[2][i]};
    if (surface.level >= settings.max_trace_level) continue;
    const double share = std::min(1.0, static_cast<double>(std::abs(grey(surface.filter))));
    if (share > settings.adc_bailout && spawn_transmission(surface)) continue;
    spawn_reflections(surface, std::bit_cast<PackedDirection>(block.mirrored[i]));
  }
}

void Stepper::spawn_feelers(std::uint32_t first_light, std::size_t light_count) {
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    Surface& surface = surfaces_[i];
    std::array<PackedRgb, kLightsAtOnce> at_stake{};
    std::uint32_t which = 0;
    std::size_t count = 0;
    for (std::size_t l = 0; l < light_count; ++l) {
      const std::uint64_t bits = block_->light[l][i];
      at_stake[count] = PackedRgb::from_bits(bits);
      which |= static_cast<std::uint32_t>(bits != 0) << l;
      count += bits != 0;
    }
    if (count == 0) continue;
    if (count <= RayTask::kMostFeelers && surface.open_record == kNoRecord) {
      surface.open_record = spawned_.size();
      RayTask& record = spawned_.emplace_back(child_of(surface, RayKind::shadow));
      const auto first = static_cast<std::uint32_t>(std::countr_zero(which));
      record.path = (first_light + first) | which >> first >> 1 << RayTask::kFirstLightBits;
      std::copy_n(at_stake.begin(), RayTask::kMostFeelers, record.light_at_stake.begin());
      surface.sum->outstanding += block_->at_stake[i];
      continue;
    }
    for (std::size_t f = 0; f < count; ++f, which &= which - 1) {
      add_feeler(surface, first_light + static_cast<std::uint32_t>(std::countr_zero(which)), at_stake[f]);
    }
  }
}

void Stepper::add_feeler(Surface& surface, std::uint32_t light, PackedRgb at_stake) {
  if (surface.open_record != kNoRecord) {
    RayTask& record = spawned_[surface.open_record];
    const std::int64_t before = bound_.at_stake(record);
    if (record.add_feeler(light, at_stake)) {
      surface.sum->outstanding += bound_.at_stake(record) - before;
      return;
    }
  }
  surface.open_record = spawned_.size();
  spawned_.push_back(child_of(surface, RayKind::shadow));
  spawned_.back().set_feeler(light, at_stake);
  surface.sum->outstanding += bound_.at_stake(spawned_.back());
}

RayTask Stepper::child_of(const Surface& surface, RayKind kind) const {
  RayTask child;
  child.origin = surface.point;
  child.sample = surface.task->sample;
  child.medium = surface.task->medium;
  child.kind = kind;
  child.level = static_cast<std::uint8_t>(std::min(surface.level, 255));
  child.flags = surface.task->flags & RayTask::kReflected;
  child.object = static_cast<std::uint16_t>(std::min<std::uint32_t>(surface.part->object, RayTask::kNoObject));
  return child;
}

Rgb Stepper::reflectivity(const Surface& surface, const Finish& finish, const Rgb& color, double& adc_weight) const {
  const float strongest = std::max(max_component(finish.reflection_max), max_component(finish.reflection_min));
  if (is_black(finish.reflection_max) && is_black(finish.reflection_min)) {
    adc_weight *= strongest;
    return Rgb(0.0f);
  }
  const double cosine = -surface.direction.dot(surface.normal);
  Rgb reflected;
  if (finish.reflection_fresnel) {
    // Unpolarised light: 1/2 ((g-c)/(g+c))^2 (1 + ((c(g+c)-1)/(c(g-c)+1))^2), g^2 = n^2 + c^2 - 1.
    const double ior = relative_ior(surface);
    const double g2 = ior * ior + cosine * cosine - 1.0;
    if (g2 > 0.0) {
      const double g = std::sqrt(g2);
      const double ratio = (g - cosine) / (g + cosine);
      const double polarised = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
      const float f = static_cast<float>(std::clamp(0.5 * ratio * ratio * (1.0 + polarised * polarised), 0.0, 1.0));
      reflected = finish.reflection_max * f + finish.reflection_min * (1.0f - f);
    } else {
      reflected = finish.reflection_max;
    }
    adc_weight *= max_component(reflected);
  } else {
    adc_weight *= strongest;
    const double grazing = 1.0 - cosine;
    const double fraction = std::abs(finish.reflection_falloff - 1.0) > kNegligible
                                ? std::pow(grazing, finish.reflection_falloff)
                                : grazing;
    reflected = finish.reflection_max * static_cast<float>(fraction) +
                finish.reflection_min * static_cast<float>(1.0 - fraction);
  }
  if (finish.reflection_metallic != 0.0) {
    reflected = metallic_tint(reflected, color, finish.reflection_metallic, cosine);
  }
  return reflected;
}

double Stepper::relative_ior(const Surface& surface) const {
  const Scene& scene = context_.scene;
  const MediumTable& media = context_.media;
  const std::uint32_t medium = surface.task->medium;
  const double ior = scene.interiors[surface.part->interior].ior;
  if (medium == MediumTable::kOutside) return ior / scene.settings.atmosphere_ior;
  const double around = scene.interiors[media.innermost(medium)].ior;
  if (!media.contains(medium, surface.part->interior)) return ior / around;
  return (media.depth(medium) == 1 ? scene.settings.atmosphere_ior : around) / ior;
}

void Stepper::spawn_reflections(const Surface& surface, PackedDirection mirrored) {
  for (std::uint32_t i = 0; i < surface.layer_count; ++i) {
    const Layer& layer = layers_[surface.first_layer + i];
    if (is_black(layer.reflection)) continue;
    RayTask child = child_of(surface, RayKind::reflection);
    child.radiance.direction = mirrored;
    child.radiance.set_weight(surface.task->radiance.weight() * layer.reflection);
    child.radiance.adc_weight = static_cast<float>(layer.adc_weight);
    child.flags |= RayTask::kReflected;
    child.path = mixed(surface.task->path, 0x10000u + i);
    if (!is_worth_tracing(context_.scene.settings, child)) continue;
    if (layer.finish->reflection_exponent != 1.0) {
      add_sealed(surface, child, child.radiance.weight(), layer.finish->reflection_exponent);
    } else {
      spawn(surface, child);
    }
  }
}

bool Stepper::spawn_transmission(const Surface& surface) {
  const Scene& scene = context_.scene;
  MediumTable& media = context_.media;
  const Interior& interior = scene.interiors[surface.part->interior];
  const std::uint32_t own = surface.part->interior;
  const std::uint32_t around = surface.task->medium;

  // Nested matter counts as outside of what surrounds it; of overlapping matter, the one met last fills the overlap.
  RayTask child = child_of(surface, RayKind::transmission);
  double ior = 1.0;  // of the side the ray comes from, relative to the side it goes to
  if (around == MediumTable::kOutside) {
    child.medium = media.entered(around, own);
    ior = scene.settings.atmosphere_ior / interior.ior;
  } else if (media.innermost(around) == own) {
    child.medium = media.left(around, own);
    const double beyond = child.medium == MediumTable::kOutside ? scene.settings.atmosphere_ior
                                                                : scene.interiors[media.innermost(child.medium)].ior;
    ior = interior.ior / beyond;
  } else if (media.contains(around, own)) {
    child.medium = media.left(around, own);
  } else {
    ior = scene.interiors[media.innermost(around)].ior / interior.ior;
    child.medium = media.entered(around, own);
  }

  Rgb passed = Rgb(static_cast<float>(interior.refraction_scale));
  if (std::abs(interior.fade_distance) > kNegligible && media.contains(around, own)) {
    passed *= faded_light(interior, surface.depth);
  }
  child.radiance.adc_weight = surface.task->radiance.adc_weight * max_magnitude(surface.filter);
  child.path = mixed(surface.task->path, 0x20000u);

  bool totally_reflected = false;
  if (std::abs(ior - 1.0) < kNegligible) {
    child.radiance.direction = PackedDirection(surface.direction);
    child.flags |= RayTask::kContinued;
  } else {
    // Heckbert's form of Snell's law: T = ior I + (ior c - sqrt(1 + ior^2 (c^2 - 1))) N.
    const double cosine = -surface.direction.dot(surface.normal);
    const double root = 1.0 + ior * ior * (cosine * cosine - 1.0);
    totally_reflected = root < 0.0;
    if (totally_reflected) {
      child.kind = RayKind::reflection;
      child.flags |= RayTask::kReflected;
      child.medium = around;
      child.radiance.direction = PackedDirection(surface.direction + surface.normal * (2.0 * cosine));
    } else {
      child.radiance.direction =
          PackedDirection(surface.direction * ior + surface.normal * (ior * cosine - std::sqrt(root)));
    }
  }
  child.radiance.set_weight(surface.task->radiance.weight() * passed *
                            (totally_reflected ? Rgb(1.0f) : surface.filter));
  if (is_worth_tracing(scene.settings, child)) spawn(surface, child);
  return totally_reflected;
}

}  // namespace firstlight::render
