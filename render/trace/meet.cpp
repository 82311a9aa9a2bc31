// The surfaces that rays meet: which textures they wear, what their layers are there, and what they reflect.

#include "render/lanes/math.h"
#include "render/trace/film_thickness.h"
#include "render/trace/local_light.h"
#include "render/trace/shape_runs.h"
#include "render/trace/step.h"
#include "render/trace/worn_textures.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

/// Clears a layer for hits that have none. The share too, for what was there before need not be a number.
void clear_amounts(LayerColumns& layer, std::size_t count) {
  for (Column<double>& column : layer.share.of) std::fill_n(column.at.begin(), count, 0.0);
  for (Column<double>* column : {&layer.diffuse, &layer.specular}) std::fill_n(column->at.begin(), count, 0.0);
  layer.has_rare = false;
  layer.tilted = 0;
}

/// Sets the amounts that few surfaces have. The first that has them sets what the others have instead.
void set_rare(LayerColumns& columns, std::size_t hit, std::size_t count, const SurfaceLayer& layer, double opacity) {
  if (!columns.has_rare) {
    columns.has_rare = true;
    for (Column<double>* column : {&columns.diffuse_back, &columns.phong, &columns.phong_size, &columns.metallic,
                                   &columns.crand, &columns.crand_back, &columns.irid, &columns.film}) {
      std::fill_n(column->at.begin(), count, 0.0);
    }
    std::fill_n(columns.brilliance.at.begin(), count, 1.0);
  }
  columns.diffuse_back[hit] = layer.diffuse_back * opacity;
  columns.brilliance[hit] = layer.brilliance;
  columns.phong[hit] = layer.phong;
  columns.phong_size[hit] = layer.phong_size;
  columns.metallic[hit] = layer.metallic;
  // Chance takes of what shines on a side that shines back at all, but nothing less where little of the layer is left.
  columns.crand[hit] = layer.diffuse > 0.0 ? layer.crand : 0.0;
  columns.crand_back[hit] = layer.diffuse_back > 0.0 ? layer.crand : 0.0;
  columns.irid[hit] = layer.irid;
}

/// Lights behind the hit may shine on what is tilted.
void set_normal(HitBlock& block, LayerColumns& columns, std::size_t hit, const Vec3& normal) {
  columns.tilted |= std::uint64_t{1} << hit;
  columns.normal.set(hit, normal);
  block.lit_from_behind = true;
}

}  // namespace

inline std::uint32_t Stepper::next_column(Surface& surface) {
  HitBlock& block = *block_;
  const std::uint32_t k = surface.layer_count++;
  if (k == block.layer_count) {
    if (k == block.layers.size()) block.layers.emplace_back();
    clear_amounts(block.layers[k], block.capacity);
    ++block.layer_count;
  }
  return k;
}

inline void Stepper::lay(std::uint32_t column, std::size_t hit, const SurfaceLayer& layer, const LayerColor& color,
                         const Rgb& share) {
  HitBlock& block = *block_;
  LayerColumns& columns = block.layers[column];
  columns.color.set(hit, color.rgb);
  columns.share.set(hit, share);
  columns.diffuse[hit] = layer.diffuse * color.opacity;
  columns.specular[hit] = layer.specular;
  columns.specular_exponent[hit] = layer.specular_exponent;
  if (!layer.has_rare) return;
  set_rare(columns, hit, block.capacity, layer, color.opacity);
  block.lit_from_behind |= layer.diffuse_back != 0.0;
  if (layer.irid != 0.0) {
    columns.film[hit] =
        film_thickness(*layer.source->finish, block.point.vector(hit), context_.scene.settings.noise_generator);
  }
}

inline Stepper::Coating& Stepper::begin_coating(std::size_t hit, double share) {
  const Surface& surface = surfaces_[hit];
  Coating& coating = coatings_.emplace_back();
  coating.hit = static_cast<std::uint32_t>(hit);
  coating.column = surface.layer_count;
  coating.weight = surface.weight;
  coating.clear = surface.clear * static_cast<float>(share);
  if (share != 1.0) coating.weight *= static_cast<float>(share);
  coating.first_mirror = static_cast<std::uint32_t>(mirrors_.size());
  return coating;
}

inline void Stepper::put_on(std::size_t hit, const Coat& coat, double of_texture) {
  Surface& surface = surfaces_[hit];
  Coating& coating = begin_coating(hit, of_texture);
  const SettledCoat& settled = coat.settled;
  for (const SurfaceLayer& layer : table_->layers(coat).first(settled.seen)) {
    const std::uint32_t column = next_column(surface);
    lay(column, hit, layer, layer.color, coating.weight * layer.filter_above);
    if (!layer.reflects) continue;
    double adc_weight = surface.task->adc_weight() * layer.share_above;
    const double steepness =
        layer.is_even_mirror ? 0.0 : -block_->direction.vector(hit).dot(block_->normal.vector(hit));
    const Rgb reflection = reflectivity(surface, steepness, layer, layer.color.rgb, adc_weight);
    mirrors_.push_back({&layer, reflection, column, adc_weight});
  }
  coating.filter = settled.filter;
  coating.share = settled.share;
  coating.mirror_count = static_cast<std::uint32_t>(mirrors_.size()) - coating.first_mirror;
  surface.own_light += coating.weight * settled.own_light;
}

inline void Stepper::wear(std::size_t hit, std::uint32_t texture, double share) {
  if (const Coat* coat = table_->settled_coat(texture)) {
    put_on(hit, *coat, share);
  } else {
    uneven_.push_back({texture, static_cast<std::uint8_t>(hit), share});
  }
}

void Stepper::find_normals(std::span<const std::uint8_t> rays) {
  HitBlock& block = *block_;
  std::size_t place = block.size;
  std::uint64_t places = 0;
  for (const std::size_t i : rays) {
    const Ray ray{rays_->origin.vector(i), rays_->direction.vector(i)};
    block.point.set(place, ray.at(hits_[i].depth));
    block.crossing[place] = &hits_[i];
    places |= std::uint64_t{1} << place++;
  }
  for_each_run(block, places, [&](const Shape& shape, std::size_t first, std::size_t end) {
    shape.normals(block, first, end, block.normal);
  });
}

void Stepper::meet(std::size_t place, std::size_t number, const RayTask& task, Contribution& sum) {
  HitBlock& block = *block_;
  const Part& part = context_.scene.parts[hits_[number].part];
  const Vec3 direction = rays_->direction.vector(number);
  const Vec3 normal = block.normal.vector(place);
  const bool from_inside = normal.dot(direction) > 0.0;
  const bool has_own = shows_own_textures(part, from_inside);
  const std::uint32_t texture = has_own ? kNoIndex : only_texture(part, from_inside);
  if (texture == kNoIndex && !has_own) return;

  const bool continued = (task.flags & RayTask::kContinued) != 0;
  const std::size_t i = block.size++;
  if (i != place) {
    block.point.set(i, block.point.vector(place));
    block.crossing[i] = block.crossing[place];
  }
  block.direction.set(i, direction);
  block.normal.set(i, from_inside ? -normal : normal);
  block.lit_from[i] = part.double_illuminate ? -2.0 : kNegligible;
  block.lit_from_behind |= part.double_illuminate;
  Surface& surface = surfaces_[i];
  surface.task = &task;
  surface.part = &part;
  surface.sum = &sum;
  surface.weight = light_weight(task, number);
  surface.clear = clear_weight(task, number);
  surface.level = task.level + (continued ? 0 : 1);
  surface.layer_count = 0;
  surface.own_light = Rgb(0.0f);
  surface.open_record = kNoRecord;
  if (has_own) {
    own_textures_ |= std::uint64_t{1} << i;
  } else {
    wear(i, texture, 1.0);
  }
}

void Stepper::wear_own_textures() {
  for_each_own_texture(context_.scene, *block_, own_textures_, worn_,
                       [&](std::size_t hit, std::uint32_t texture, double share) { wear(hit, texture, share); });
}

// In the order of textures' numbers, and each with its coats in the order of its maps, so that what is added up for a
// hit does not depend on the other hits of the block.
void Stepper::meet_uneven() {
  if (!std::ranges::is_sorted(uneven_, {}, &Uneven::texture)) std::ranges::stable_sort(uneven_, {}, &Uneven::texture);
  std::uint64_t by_uv = 0;
  for (const Uneven& uneven : uneven_) {
    const bool asks = table_->goes_by_uv(uneven.texture) || surfaces_[uneven.hit].part->uv_mapping;
    by_uv |= static_cast<std::uint64_t>(asks) << uneven.hit;
  }
  for_each_run(*block_, by_uv,
               [&](const Shape& shape, std::size_t first, std::size_t end) { shape.uvs(*block_, first, end, uvs_); });
  for (std::size_t first = 0; first < uneven_.size();) {
    const std::uint32_t texture = uneven_[first].texture;
    std::size_t end = first;
    while (end < uneven_.size() && end - first < kRaysAtOnce && uneven_[end].texture == texture) ++end;
    ask_uneven(texture, std::span(uneven_).subspan(first, end - first));
    coats_.clear();
    table_->unfold(texture, *asked_, coats_);
    for (std::size_t c = 0; c < coats_.size(); ++c) {
      CoatPoints& coat = coats_[c];
      const std::span<const SurfaceLayer> layers = table_->layers(*coat.coat);
      if (looks_.size() < layers.size()) looks_.resize(layers.size());
      for (std::size_t k = 0; k < layers.size(); ++k) table_->look(layers[k], coat, looks_[k]);
      for (std::size_t k = 0; k < coat.points.size; ++k) {
        const Uneven& uneven = uneven_[first + coat.lane[k]];
        put_on_uneven(uneven.hit, *coat.coat, coat.share[k] * uneven.share, k);
      }
    }
    first = end;
  }
}

void Stepper::ask_uneven(std::uint32_t texture, std::span<const Uneven> hits) {
  const HitBlock& block = *block_;
  SurfacePoints& points = *asked_;
  points.size = hits.size();
  points.on_surface = table_->goes_by_surface(texture);
  const bool asks_uv = table_->goes_by_uv(texture);
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const std::size_t hit = hits[k].hit;
    const Vec3 point = block.point.vector(hit);
    points.at.set(k, point);
    if (points.on_surface) {
      const Vec3 normal = block.normal.vector(hit);
      points.place.set(k, point);
      points.normal.set(k, normal);
      points.tilted.set(k, normal);
      points.direction.set(k, block.direction.vector(hit));
      points.uv.set(k, Vec2(0.0));
    }
    const bool uv_mapping = surfaces_[hit].part->uv_mapping;
    if (!asks_uv && !uv_mapping) continue;
    const Vec2 uv = uvs_.vector(hit);
    points.uv.set(k, uv);
    if (uv_mapping) points.at.set(k, Vec3(uv.x, uv.y, 0.0));
  }
}

void Stepper::put_on_uneven(std::size_t hit, const Coat& coat, double of_texture, std::size_t lane) {
  HitBlock& block = *block_;
  Surface& surface = surfaces_[hit];
  const double bailout = context_.scene.settings.adc_bailout;
  const bool has_light = context_.scene.settings.quality.has_light();
  Coating& coating = begin_coating(hit, of_texture);
  double share = 1.0;
  Rgb filter(1.0f);
  Rgb own_light(0.0f);
  bool found_any = false;
  const std::span<const SurfaceLayer> layers = table_->layers(coat);
  for (std::size_t l = 0; l < layers.size() && share > bailout; ++l) {
    const SurfaceLayer& layer = layers[l];
    LayerColor at_point;
    bool found = true;
    if (!layer.is_plain) {
      at_point = table_->color(layer, looks_[l].colors.color(lane));
      found = (looks_[l].colors.missing >> lane & 1u) == 0;
    }
    found_any |= found;
    const LayerColor& color = layer.is_plain ? layer.color : at_point;
    const std::uint32_t column = next_column(surface);
    lay(column, hit, layer, color, coating.weight * filter);
    Vec3 normal = block.normal.vector(hit);
    if (layer.normal != nullptr) {
      normal = looks_[l].normals.vector(lane);
      set_normal(block, block.layers[column], hit, normal);
    }
    own_light = has_light ? own_light + filter * color.own_light : color.own_light;

    Rgb reflection(0.0f);
    if (layer.reflects) {
      double adc_weight = surface.task->adc_weight() * share;
      reflection = reflectivity(surface, -block.direction.vector(hit).dot(normal), layer, color.rgb, adc_weight);
      mirrors_.push_back({&layer, reflection, column, adc_weight});
    }
    if (found) filter *= passed_below(layer, color.passed, reflection);
    share = share_of(filter);
  }
  coating.filter = found_any ? filter : Rgb(1.0f);
  coating.share = share;
  coating.mirror_count = static_cast<std::uint32_t>(mirrors_.size()) - coating.first_mirror;
  surface.own_light += coating.weight * own_light;
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
                                ? steady::power(grazing, finish.reflection_falloff)
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
  if (media.is_outside(medium)) return ior / scene.settings.atmosphere_ior;
  const double around = scene.interiors[media.innermost(medium)]->ior;
  if (!media.contains(medium, surface.part->interior)) return ior / around;
  return (media.depth(medium) == 1 ? scene.settings.atmosphere_ior : around) / ior;
}

}  // namespace firstlight::render
