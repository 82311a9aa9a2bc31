// The surfaces that rays meet: their own light, lights as if unoccluded, and the rays they send on.

#include "render/math/interrupt.h"
#include "render/math/noise.h"
#include "render/trace/fade.h"
#include "render/trace/local_light.h"
#include "render/trace/step.h"
#include "render/trace/worn_textures.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

/// Of a layer for hits that have none. The share too, for what was there before need not be a number.
void clear_amounts(LayerColumns& layer, std::size_t count) {
  for (Column<double>& column : layer.share.of) std::fill_n(column.at.begin(), count, 0.0);
  for (Column<double>* column : {&layer.diffuse, &layer.specular}) std::fill_n(column->at.begin(), count, 0.0);
  layer.has_rare = false;
  layer.tilted = 0;
}

/// What few surfaces have. The first that has it sets what the others have instead.
void set_rare(LayerColumns& columns, std::size_t hit, std::size_t count, const SurfaceLayer& layer, double opacity) {
  if (!columns.has_rare) {
    columns.has_rare = true;
    for (Column<double>* column : {&columns.diffuse_back, &columns.phong, &columns.phong_size, &columns.metallic,
                                   &columns.crand, &columns.irid, &columns.film}) {
      std::fill_n(column->at.begin(), count, 0.0);
    }
    std::fill_n(columns.brilliance.at.begin(), count, 1.0);
  }
  columns.diffuse_back[hit] = layer.diffuse_back * opacity;
  columns.brilliance[hit] = layer.brilliance;
  columns.phong[hit] = layer.phong;
  columns.phong_size[hit] = layer.phong_size;
  columns.metallic[hit] = layer.metallic;
  columns.crand[hit] = layer.crand;
  columns.irid[hit] = layer.irid;
}

/// Thickness of the film on a layer, which its turbulence makes uneven.
double film_at(const Finish& finish, const Vec3& point, int noise_generator) {
  if (finish.irid_turbulence == 0.0) return finish.irid_thickness;
  const double noise = turbulence(point, {5, 2.0f, 0.5f}, noise_generator);
  return finish.irid_thickness * (1.0 + (2.0 * noise - 1.0) * finish.irid_turbulence);
}

/// Lights behind the hit may shine on what is tilted.
void set_normal(HitBlock& block, LayerColumns& columns, std::size_t hit, const Vec3& normal) {
  columns.tilted |= std::uint64_t{1} << hit;
  columns.normal.set(hit, normal);
  block.lit_from_behind = true;
}

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

void Stepper::meet(const RayTask& task, const Ray& ray, const Hit& hit, const Rgb& weight, Contribution& sum) {
  const Part& part = context_.scene.parts[hit.part];
  const Vec3 point = ray.at(hit.depth);
  const Crossing crossing = hit.crossing();
  Vec3 normal = hit.shape->normal(point, crossing);
  const bool from_inside = normal.dot(ray.direction) > 0.0;
  if (from_inside) normal = -normal;
  if (part.texture == kNoIndex && !part.has_shape_textures && !(from_inside && part.interior_texture != kNoIndex)) return;

  const bool continued = (task.flags & RayTask::kContinued) != 0;
  HitBlock& block = *block_;
  const std::size_t i = block.size++;
  block.point.set(i, point);
  block.direction.set(i, ray.direction);
  block.normal.set(i, normal);
  block.lit_from[i] = part.double_illuminate ? -2.0 : kNegligible;
  block.lit_from_behind |= part.double_illuminate;
  Surface& surface = surfaces_[i];
  surface.task = &task;
  surface.part = &part;
  surface.sum = &sum;
  surface.crossing = crossing;
  surface.weight = weight;
  surface.level = task.level + (continued ? 0 : 1);
  surface.layer_count = 0;
  surface.own_light = Rgb(0.0f);
  surface.open_record = kNoRecord;
  for_each_texture(context_.scene, point, crossing, from_inside, worn_,
                   [&](std::uint32_t texture, double share) { wear(i, texture, share); });
}

void Stepper::wear(std::size_t hit, std::uint32_t texture, double share) {
  if (const Coat* coat = table_->even_coat(texture)) {
    put_on<true>(hit, *coat, share, {}, 0);
  } else {
    uneven_.push_back({texture, static_cast<std::uint8_t>(hit), share});
  }
}

// In the order of textures' numbers, and each with its coats in the order of its maps, so that what is added up for a hit
// does not depend on the other hits of the block.
void Stepper::meet_uneven() {
  std::ranges::stable_sort(uneven_, {}, &Uneven::texture);
  const HitBlock& block = *block_;
  const auto points = std::make_unique_for_overwrite<SurfacePoints>();
  points->on_surface = true;
  for (std::size_t first = 0; first < uneven_.size();) {
    const std::uint32_t texture = uneven_[first].texture;
    const bool asks_uv = table_->goes_by_uv(texture);
    std::size_t end = first;
    for (; end < uneven_.size() && end - first < kRaysAtOnce && uneven_[end].texture == texture; ++end) {
      const std::size_t k = end - first;
      const std::size_t hit = uneven_[end].hit;
      points->at.set(k, block.point.vector(hit));
      points->place.set(k, block.point.vector(hit));
      points->normal.set(k, block.normal.vector(hit));
      points->tilted.set(k, block.normal.vector(hit));
      points->direction.set(k, block.direction.vector(hit));
      points->u[k] = 0.0;
      points->v[k] = 0.0;
      const Surface& surface = surfaces_[hit];
      if (!asks_uv && !surface.part->uv_mapping) continue;
      const Vec2 uv = surface.crossing.shape->uv(block.point.vector(hit), surface.crossing);
      points->u[k] = uv.x;
      points->v[k] = uv.y;
      if (surface.part->uv_mapping) points->at.set(k, Vec3(uv.x, uv.y, 0.0));
    }
    points->size = end - first;
    coats_.clear();
    table_->unfold(texture, *points, coats_);
    for (const auto& coat : coats_) {
      const std::span<const SurfaceLayer> layers = table_->layers(*coat->coat);
      if (looks_.size() < layers.size()) looks_.resize(layers.size());
      for (std::size_t k = 0; k < layers.size(); ++k) table_->look(layers[k], *coat, looks_[k]);
      for (std::size_t k = 0; k < coat->points.size; ++k) {
        const Uneven& uneven = uneven_[first + coat->lane[k]];
        put_on<false>(uneven.hit, *coat->coat, coat->share[k] * uneven.share, looks_, k);
      }
    }
    first = end;
  }
}

template <bool kIsEven>
void Stepper::put_on(std::size_t hit, const Coat& coat, double of_texture, std::span<const LayerLook> looks,
                     std::size_t lane) {
  HitBlock& block = *block_;
  Surface& surface = surfaces_[hit];
  const double bailout = context_.scene.settings.adc_bailout;
  Coating& coating = coatings_.emplace_back();
  coating.hit = hit;
  coating.weight = surface.weight;
  if (of_texture != 1.0) coating.weight *= static_cast<float>(of_texture);
  coating.first_mirror = mirrors_.size();
  double share = 1.0;
  Rgb filter(1.0f);
  Rgb own_light(0.0f);
  bool found_any = false;
  const std::span<const SurfaceLayer> layers = table_->layers(coat);
  for (std::size_t l = 0; l < layers.size() && share > bailout; ++l) {
    const SurfaceLayer& layer = layers[l];
    LayerColor at_point;
    bool found = true;
    if (!kIsEven && !layer.is_plain) {
      at_point = table_->color(layer, looks[l].colors.color(lane));
      found = (looks[l].colors.missing >> lane & 1u) == 0;
    }
    found_any |= found;
    const LayerColor& color = kIsEven || layer.is_plain ? layer.color : at_point;
    const std::size_t k = surface.layer_count++;
    if (k == block.layer_count) {
      if (k == block.layers.size()) block.layers.emplace_back();
      clear_amounts(block.layers[k], block.capacity);
      ++block.layer_count;
    }
    LayerColumns& columns = block.layers[k];
    columns.color.set(hit, color.rgb);
    columns.share.set(hit, l == 0 ? coating.weight : coating.weight * filter);
    columns.diffuse[hit] = layer.diffuse * color.opacity;
    columns.specular[hit] = layer.specular;
    columns.specular_exponent[hit] = layer.specular_exponent;
    if (layer.has_rare) {
      set_rare(columns, hit, block.capacity, layer, color.opacity);
      block.lit_from_behind |= layer.diffuse_back != 0.0;
      if (layer.irid != 0.0) {
        columns.film[hit] = film_at(*layer.source->finish, block.point.vector(hit), context_.scene.settings.noise_generator);
      }
    }
    Vec3 normal(0.0);
    const bool is_tilted = !kIsEven && layer.normal != nullptr;
    if (is_tilted) {
      normal = looks[l].normals.vector(lane);
      set_normal(block, columns, hit, normal);
      if (l == 0) {
        coating.is_tilted = true;
        coating.normal = normal;
      }
    }
    own_light += l == 0 ? color.own_light : filter * color.own_light;

    Rgb passed = color.passed;
    if (layer.reflects) {
      double adc_weight = surface.task->adc_weight() * share;
      const double steepness =
          layer.is_even_mirror
              ? 0.0  // not asked
              : -block.direction.vector(hit).dot(is_tilted ? normal : block.normal.vector(hit));
      const Rgb reflection = reflectivity(surface, steepness, layer, color.rgb, adc_weight);
      mirrors_.push_back({&layer, reflection, adc_weight, is_tilted, normal});
      if (layer.source->finish->conserve_energy) {
        const Rgb kept = Rgb(1.0f) - reflection;
        passed *= Rgb(std::min(1.0f, kept.x), std::min(1.0f, kept.y), std::min(1.0f, kept.z));
      }
    }
    if (found) filter *= passed;
    share = is_black(filter) ? 0.0 : std::min(1.0, static_cast<double>(std::abs(grey(filter))));
  }
  coating.filter = found_any ? filter : Rgb(1.0f);
  coating.share = share;
  coating.mirror_count = mirrors_.size() - coating.first_mirror;
  surface.own_light += coating.weight * own_light;
}

void Stepper::shade() {
  HitBlock& block = *block_;
  complete_normals(block);
  for (std::size_t i = 0; i < block.size; ++i) block.own_light.set(i, surfaces_[i].own_light);
  begin_light(block);
  if (block.layer_count > 0) {
    const std::span<const Light> lights = context_.scene.lights;
    const FeelerStarts starts{block.point, block.normal, block.size, block.lit_from_behind};
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
    spawn_reflections(coating, coating.share > settings.adc_bailout && spawn_transmission(coating));
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

// In place: a record that is put together elsewhere and copied in wider pieces waits for its own parts.
void Stepper::begin_child(RayTask& child, std::size_t hit, RayKind kind) const {
  const Surface& surface = surfaces_[hit];
  child.origin = block_->point.vector(hit);
  child.sample = surface.task->sample;
  child.medium = surface.task->medium;
  child.kind = kind;
  child.level = static_cast<std::uint8_t>(std::min(surface.level, 255));
  child.flags = surface.task->flags & RayTask::kReflected;
  child.object = static_cast<std::uint16_t>(std::min<std::uint32_t>(surface.part->object, RayTask::kNoObject));
}

void Stepper::end_ray(const Surface& surface) {
  const RayTask& ray = spawned_.back();
  if (ray.is_black() || !is_worth_tracing(context_.scene.settings, ray)) {
    spawned_.pop_back();
  } else {
    surface.sum->outstanding += bound_.at_stake(ray);
  }
}

Rgb Stepper::reflectivity(const Surface& surface, double steepness, const SurfaceLayer& layer, const Rgb& color,
                          double& adc_weight) const {
  if (layer.is_even_mirror) {
    adc_weight *= layer.strongest;
    return layer.reflection;
  }
  const Finish& finish = *layer.source->finish;
  const double cosine = steepness;
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
    adc_weight *= layer.strongest;
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
  const double ior = scene.interiors[surface.part->interior]->ior;
  if (medium == MediumTable::kOutside) return ior / scene.settings.atmosphere_ior;
  const double around = scene.interiors[media.innermost(medium)]->ior;
  if (!media.contains(medium, surface.part->interior)) return ior / around;
  return (media.depth(medium) == 1 ? scene.settings.atmosphere_ior : around) / ior;
}

// A ray that a tilted normal would send below the surface is turned up again. [POV-Ray 3.7]
Vec3 Stepper::reflected_by(std::size_t hit, const Vec3& normal) const {
  const Vec3 direction = block_->direction.vector(hit);
  const Vec3 bare = block_->normal.vector(hit);
  Vec3 reflected = direction - normal * (2.0 * direction.dot(normal));
  const double above = reflected.dot(bare);
  if (above < 0.0) {
    reflected = reflected.dot(normal) < 0.0 ? direction - bare * (2.0 * direction.dot(bare))
                                            : reflected - bare * (2.0 * above);
  }
  return reflected.normalized();
}

/// As film_tint() in light_block.cpp, of light that is mirrored.
Rgb Stepper::film_color(std::size_t hit, const Mirror& mirror, PackedDirection reflected) const {
  const Settings& settings = context_.scene.settings;
  const Vec3 normal = mirror.is_tilted ? mirror.normal : block_->normal.vector(hit);
  const double film =
      film_at(*mirror.layer->source->finish, block_->point.vector(hit), settings.noise_generator);
  const double cosines = std::abs(normal.dot(reflected.unpack())) + std::abs(normal.dot(block_->direction.vector(hit)));
  const double way = 2.0 * std::numbers::pi * film * cosines;
  const auto channel = [&](float wavelength) {
    return static_cast<float>(1.0 + mirror.layer->irid * std::cos(way / static_cast<double>(wavelength)));
  };
  const Rgb& lengths = settings.irid_wavelength;
  return {channel(lengths.x), channel(lengths.y), channel(lengths.z)};
}

void Stepper::spawn_reflections(const Coating& coating, bool totally) {
  const Surface& surface = surfaces_[coating.hit];
  for (const Mirror& mirror : std::span(mirrors_).subspan(coating.first_mirror, coating.mirror_count)) {
    if (is_black(mirror.reflection)) continue;
    if (totally) {
      const Vec3 bare = block_->normal.vector(coating.hit);
      const Vec3 gap = (coating.is_tilted ? coating.normal : bare) - (mirror.is_tilted ? mirror.normal : bare);
      if (std::max({std::abs(gap.x), std::abs(gap.y), std::abs(gap.z)}) <= kNegligible) continue;
    }
    RayTask& child = spawned_.emplace_back();
    begin_child(child, coating.hit, RayKind::reflection);
    child.set_direction(mirror.is_tilted ? PackedDirection(reflected_by(coating.hit, mirror.normal))
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
    if (is_worth_tracing(context_.scene.settings, root)) add_sealed(surface, root, exponent);
  }
}

bool Stepper::spawn_transmission(const Coating& coating) {
  const std::size_t hit = coating.hit;
  const Surface& surface = surfaces_[hit];
  const Scene& scene = context_.scene;
  MediumTable& media = context_.media;
  const Interior& interior = scene.interiors[surface.part->interior];
  const std::uint32_t own = surface.part->interior;
  const std::uint32_t around = surface.task->medium;

  // Nested matter counts as outside of what surrounds it; of overlapping matter, the one met last fills the overlap.
  RayTask& child = spawned_.emplace_back();
  begin_child(child, hit, RayKind::transmission);
  double ior = 1.0;  // of the side the ray comes from, relative to the side it goes to
  if (around == MediumTable::kOutside) {
    child.medium = media.entered(around, own);
    ior = scene.settings.atmosphere_ior / interior.ior;
  } else if (media.innermost(around) == own) {
    child.medium = media.left(around, own);
    const double beyond = child.medium == MediumTable::kOutside ? scene.settings.atmosphere_ior
                                                                : scene.interiors[media.innermost(child.medium)]->ior;
    ior = interior.ior / beyond;
  } else if (media.contains(around, own)) {
    child.medium = media.left(around, own);
  } else {
    ior = scene.interiors[media.innermost(around)]->ior / interior.ior;
    child.medium = media.entered(around, own);
  }

  Rgb passed = Rgb(static_cast<float>(interior.refraction_scale));
  if (std::abs(interior.fade_distance) > kNegligible && media.contains(around, own)) {
    passed *= faded_light(interior, surface.crossing.depth);
  }

  const Vec3 direction = block_->direction.vector(hit);
  bool totally_reflected = false;
  if (std::abs(ior - 1.0) < kNegligible) {
    child.set_direction(PackedDirection(direction));
    child.flags |= RayTask::kContinued;
  } else {
    // Heckbert's form of Snell's law: T = ior I + (ior c - sqrt(1 + ior^2 (c^2 - 1))) N, N towards the ray's origin.
    const Vec3 normal = coating.is_tilted ? coating.normal : block_->normal.vector(hit);
    const double along = -direction.dot(normal);
    const Vec3 facing = along >= 0.0 ? normal : -normal;
    const double cosine = std::abs(along);
    const double root = 1.0 + ior * ior * (cosine * cosine - 1.0);
    totally_reflected = root < 0.0;
    if (totally_reflected) {
      child.kind = RayKind::reflection;
      child.flags |= RayTask::kReflected;
      child.medium = around;
      child.set_direction(PackedDirection(coating.is_tilted ? reflected_by(hit, normal)
                                                            : direction + normal * (2.0 * cosine)));
    } else {
      child.set_direction(PackedDirection(direction * ior + facing * (ior * cosine - std::sqrt(root))));
    }
  }
  child.set_weight(coating.weight * passed * (totally_reflected ? Rgb(1.0f) : coating.filter),
                   surface.task->adc_weight() * max_magnitude(coating.filter));
  end_ray(surface);
  return totally_reflected;
}

}  // namespace firstlight::render
