#include "render/surface/surface_table.h"

#include "render/lanes/math.h"
#include "render/math/scratch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace firstlight::render {
namespace {

double positive(double amount) { return amount > 0.0 ? amount : 0.0; }

/// Number of the texture that a material_map of `count` has at a point: by the pixel's place in its palette, or how
/// red it is, of 255. Numbers above the count begin again; the count itself is the last. Beside the picture it is the
/// first.
/// [POV-Ray 3.7]
std::uint32_t material_at(const ImageMap& image, const Vec3& point, std::uint32_t count) {
  const auto place = image.place(point);
  if (!place) return 0;
  const ImageMap::Sample sample = image.as_stored(*place);
  const double number = sample.index != -1 ? sample.index : std::trunc(static_cast<double>(sample.color.rgb.x) * 255.0);
  if (!(number > 0.0)) return 0;
  const double materials = count;
  return static_cast<std::uint32_t>(
      std::min(number > materials ? std::fmod(number, materials) : number, materials - 1.0));
}

/// The factor on light that is gathered behind a surface of clear matter: 1 + |n.d|^(45 caustics). [POV-Ray 3.7]
float gathered(const Vec3& normal, const Vec3& direction, double caustics) {
  return static_cast<float>(1.0 + steady::power(std::abs(normal.dot(direction)), 45.0 * caustics));
}

}  // namespace

SurfaceTable::SurfaceTable(const Scene& scene)
    : scene_(&scene),
      world_{scene.settings.noise_generator, scene.settings.number_of_waves, !scene.settings.quality.has_pigments()},
      sky_(scene, world_),
      old_opacity_(scene.settings.language_version < 370),
      ambient_light_(scene.settings.ambient_light) {
  layers_.reserve(scene.textures.size());
  roots_.reserve(scene.textures.size());
  for (const PlacedTexture& placed : scene.textures) {
    const std::uint32_t node = compile(*placed.texture);
    const Coat* coat = nodes_[node].coat;
    roots_.push_back(node);
    even_.push_back(coat != nullptr && coat->is_even ? coat : nullptr);
    settled_.push_back(coat != nullptr && coat->is_settled ? coat : nullptr);
  }
  glossy_.reserve(scene.parts.size());
  for (const Part& part : scene.parts) {
    const bool is_glossy = part.has_shape_textures || (part.texture != kNoIndex && has_gloss(roots_[part.texture]));
    glossy_.push_back(static_cast<std::uint8_t>(is_glossy));
  }
}

bool SurfaceTable::has_gloss(std::uint32_t node) const {
  if (nodes_[node].coat != nullptr) return nodes_[node].coat->is_glossy;
  return std::ranges::any_of(nodes_[node].entries, [&](const auto& entry) { return has_gloss(entry.second); });
}

std::uint32_t SurfaceTable::compile(const Texture& texture) {
  const auto [found, is_new] = node_of_.try_emplace(&texture, 0);
  if (!is_new) return found->second;
  Node node;
  if (!texture.layers.empty() && texture.layers.front().extras->patterned) {
    const TexturePattern& patterned = *texture.layers.front().extras->patterned;
    node.pattern.emplace(patterned.pattern, world_);
    node.keeps_length = patterned.pattern.keeps_bump_size;
    node.by_uv = render::goes_by_uv(patterned.pattern);
    node.by_surface = render::goes_by_surface(patterned.pattern);
    for (const MapEntry<TexturePtr>& entry : patterned.textures->entries) {
      const std::uint32_t part = compile(*entry.value);
      node.entries.emplace_back(entry.position, part);
      node.by_uv = node.by_uv || nodes_[part].by_uv;
      node.by_surface = node.by_surface || nodes_[part].by_surface;
    }
  } else {
    Coat& coat = coats_.emplace_back();
    coat.first = layers_.size();
    coat.count = texture.layers.size();
    coat.is_opaque = is_opaque(texture);
    for (const TextureLayer& layer : texture.layers) {
      const SurfaceLayer& surface = layers_.emplace_back(prepared(layer));
      coat.is_even = coat.is_even && surface.is_plain && surface.normal == nullptr;
      coat.is_settled = coat.is_settled && coat.is_even && (surface.is_even_mirror || !layer.finish->conserve_energy);
      node.by_uv = node.by_uv || render::goes_by_uv(layer.pigment) ||
                   (layer.extras->normal && render::goes_by_uv(*layer.extras->normal));
      node.by_surface = node.by_surface || surface.normal != nullptr || render::goes_by_surface(layer.pigment);
      coat.is_glossy = coat.is_glossy || surface.specular > 0.0 || surface.phong > 0.0;
    }
    if (coat.is_settled) settle(coat);
    node.coat = &coat;
  }
  nodes_.push_back(std::move(node));
  return node_of_[&texture] = static_cast<std::uint32_t>(nodes_.size() - 1);
}

SurfaceLayer SurfaceTable::prepared(const TextureLayer& layer) {
  const Finish& finish = *layer.finish;
  SurfaceLayer surface;
  surface.source = &layer;
  const FilteredColor* const even = even_color(layer.pigment, world_.quick_colors);
  surface.is_plain = even != nullptr;
  if (even == nullptr) surface.pigment = &pigments_.emplace_back(layer.pigment, world_);
  if (!scene_->settings.quality.has_light()) {
    surface.own_light = Rgb(1.0f);
    surface.is_even_mirror = true;
    if (even != nullptr) surface.color = color(surface, *even);
    return surface;
  }
  surface.own_light = finish.ambient * ambient_light_ + finish.emission;
  surface.diffuse = positive(finish.diffuse);
  surface.diffuse_back = positive(finish.diffuse_back);
  surface.brilliance = finish.brilliance;
  surface.phong = finish.phong;
  surface.phong_size = finish.phong_size;
  surface.specular = finish.specular;
  surface.specular_exponent = finish.roughness_exponent;
  surface.metallic = finish.metallic;
  surface.has_rare = surface.diffuse_back != 0.0 || surface.brilliance != 1.0 || surface.phong != 0.0 ||
                     (surface.metallic > 0.0 && surface.specular != 0.0) || finish.crand > 0.0 || finish.irid > 0.0;
  surface.crand = positive(finish.crand);
  surface.irid = positive(finish.irid);

  surface.reflects = !is_black(finish.reflection_max) || !is_black(finish.reflection_min);
  surface.strongest = std::max(max_component(finish.reflection_max), max_component(finish.reflection_min));
  surface.is_even_mirror = !surface.reflects || (finish.reflection_max == finish.reflection_min &&
                                                 !finish.reflection_fresnel && finish.reflection_metallic == 0.0);
  if (surface.is_even_mirror) surface.reflection = finish.reflection_max;

  if (even != nullptr) surface.color = color(surface, *even);
  if (layer.extras->normal && scene_->settings.quality.has_normals()) {
    surface.normal = &normals_.emplace_back(*layer.extras->normal, world_, layer.extras->keeps_bump_size);
  }
  return surface;
}

void SurfaceTable::settle(Coat& coat) {
  SettledCoat& all = coat.settled;
  for (SurfaceLayer& layer : std::span(layers_).subspan(coat.first, coat.count)) {
    if (!(all.share > scene_->settings.adc_bailout)) break;
    layer.filter_above = all.filter;
    layer.share_above = all.share;
    if (all.seen++ == 0 || !scene_->settings.quality.has_light()) {
      all.own_light = layer.color.own_light;  // without light the lowest layer that is seen hides the others
    } else {
      all.own_light += all.filter * layer.color.own_light;
    }
    all.filter *= passed_below(layer, layer.color.passed, layer.reflection);
    all.share = share_of(all.filter);
  }
}

LayerColor SurfaceTable::color(const SurfaceLayer& layer, const FilteredColor& pigment) const {
  LayerColor color;
  color.rgb = pigment.rgb;
  color.passed = pigment.passed();
  // Before 3.7 a tinted layer kept more of its own light. [POV-Ray 3.7: language version below 370]
  color.opacity = old_opacity_ ? 1.0 - (pigment.filter * max_component(pigment.rgb) + pigment.transmit)
                               : 1.0 - pigment.filter - pigment.transmit;
  const auto opacity = scene_->settings.quality.has_light() ? static_cast<float>(color.opacity) : 1.0f;
  color.own_light = pigment.rgb * layer.own_light * opacity;
  return color;
}

void SurfaceTable::unfold(std::uint32_t texture, const SurfacePoints& points, CoatList& coats) const {
  const Transform& to_texture = scene_->textures[texture].to_texture;
  const bool is_placed = !to_texture.is_identity();
  Way way;
  if (is_placed) way.placement = &to_texture;
  std::array<std::uint8_t, kRaysAtOnce> lanes;
  Column<double> shares;
  for (std::size_t i = 0; i < points.size; ++i) {
    lanes[i] = static_cast<std::uint8_t>(i);
    shares[i] = 1.0;
  }
  const Node& root = nodes_[roots_[texture]];
  if (!is_placed) return unfold_node(root, way, points, lanes, shares, coats);
  Columns3<double> at;
  for (std::size_t i = 0; i < points.size; ++i) at.set(i, to_texture.point(points.at.vector(i)));
  if (root.coat != nullptr) return add_coat(root, way, points, at, lanes, shares, coats);
  const Scratch<SurfacePoints> local;
  pick(points, at, points.all(), *local);
  unfold_node(root, way, *local, lanes, shares, coats);
}

void SurfaceTable::add_coat(const Node& node, const Way& way, const SurfacePoints& points, const Columns3<double>& at,
                            const std::array<std::uint8_t, kRaysAtOnce>& lanes, const Column<double>& shares,
                            CoatList& coats) {
  CoatPoints& coat = coats.add();
  coat.coat = node.coat;
  coat.spaces = way.spaces;
  coat.placement = way.placement;
  pick(points, at, points.all(), coat.points);
  std::copy_n(lanes.begin(), points.size, coat.lane.begin());
  std::copy_n(shares.at.begin(), points.size, coat.share.at.begin());
}

void SurfaceTable::unfold_node(const Node& node, const Way& way, const SurfacePoints& points,
                               const std::array<std::uint8_t, kRaysAtOnce>& lanes, const Column<double>& shares,
                               CoatList& coats) const {
  if (node.coat != nullptr) return add_coat(node, way, points, points.at, lanes, shares, coats);
  const CompiledPattern& pattern = *node.pattern;
  const PatternKind kind = pattern.source().kind;
  Way inner = way;
  inner.spaces.push_back({way.placement, &pattern.source().warps, node.keeps_length});
  inner.placement = nullptr;
  if (kind == PatternKind::uv_mapping) {
    const Scratch<SurfacePoints> own;
    to_own_coordinates(points, *own);
    return unfold_node(nodes_[node.entries.front().second], inner, *own, lanes, shares, coats);
  }
  Columns3<double> there;
  pattern.to_pattern(points, there);
  const Scratch<SurfacePoints> picked;
  std::array<std::uint8_t, kRaysAtOnce> picked_lanes;
  Column<double> picked_shares;
  if (kind == PatternKind::average) {
    float total = 0.0f;
    for (const auto& entry : node.entries) total += static_cast<float>(entry.first);
    pick(points, there, points.all(), *picked);
    for (const auto& [weight, entry] : node.entries) {
      for (std::size_t i = 0; i < points.size; ++i) {
        picked_shares[i] = shares[i] * static_cast<double>(static_cast<float>(weight) / total);
      }
      unfold_node(nodes_[entry], inner, *picked, lanes, picked_shares, coats);
    }
    return;
  }
  const auto entries = static_cast<std::uint32_t>(node.entries.size());
  std::array<MapPlace, kRaysAtOnce> places;
  if (pattern.image() != nullptr) {
    for (std::size_t i = 0; i < points.size; ++i) {
      places[i].below = places[i].above = material_at(*pattern.image(), there.vector(i), entries);
    }
  } else {
    Column<double> values;
    pattern.places(there, points, values);
    for (std::size_t i = 0; i < points.size; ++i) {
      places[i] =
          place_in_map(values[i], entries, [&](std::uint32_t k) { return stored_position(node.entries[k].first); });
    }
  }
  for_each_entry(entries, points.size, places, [&](std::uint32_t entry, std::uint64_t bits) {
    pick(points, there, bits, *picked);
    for (std::size_t k = 0; bits != 0; bits &= bits - 1, ++k) {
      const auto i = static_cast<std::size_t>(std::countr_zero(bits));
      const MapPlace& place = places[i];
      picked_lanes[k] = lanes[i];
      picked_shares[k] = place.below == place.above ? shares[i]
                         : place.above == entry     ? shares[i] * place.fraction
                                                    : shares[i] * (1.0 - place.fraction);
    }
    unfold_node(nodes_[node.entries[entry].second], inner, *picked, picked_lanes, picked_shares, coats);
  });
}

void SurfaceTable::look(const SurfaceLayer& layer, CoatPoints& coat, LayerLook& look) const {
  SurfacePoints& points = coat.points;
  if (layer.normal != nullptr) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::copy_n(points.normal.of[axis].at.begin(), points.size, look.normals.of[axis].at.begin());
    }
    for (const NormalSpace& space : coat.spaces) space.into(points.size, look.normals);
    layer.normal->tilt(points, coat.placement, look.normals);
    if (layer.normal->keeps_length()) normalize_all(points.size, look.normals);
    for (auto space = coat.spaces.rbegin(); space != coat.spaces.rend(); ++space) {
      space->out_of(points.size, look.normals);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::copy_n(look.normals.of[axis].at.begin(), points.size, points.tilted.of[axis].at.begin());
    }
  }
  if (layer.pigment != nullptr) layer.pigment->colors(points, look.colors);
}

/// Multiplies light[k] by what passes the coat at its point k.
void SurfaceTable::filter_by(CoatPoints& coat, std::span<Rgb> light, double caustics) const {
  const Scratch<LayerLook> found;
  for (const SurfaceLayer& layer : layers(*coat.coat)) {
    if (layer.pigment != nullptr) layer.pigment->colors(coat.points, found->colors);
    for (std::size_t k = 0; k < coat.points.size; ++k) {
      if (layer.pigment == nullptr) {
        light[k] *= layer.color.passed;
      } else if ((found->colors.missing >> k & 1u) == 0) {
        light[k] *= found->colors.color(k).passed();
      }
    }
    if (caustics == 0.0) continue;
    if (layer.normal != nullptr) look(layer, coat, *found);
    for (std::size_t k = 0; k < coat.points.size; ++k) {
      const Vec3 normal = layer.normal != nullptr ? found->normals.vector(k) : coat.points.normal.vector(k);
      light[k] *= gathered(normal, coat.points.direction.vector(k), caustics);
    }
  }
}

void SurfaceTable::filter(std::uint32_t texture, const SurfacePoints& points, std::span<Rgb> light, CoatList& scratch,
                          double caustics) const {
  if (const Coat* coat = even_coat(texture)) {
    for (const SurfaceLayer& layer : layers(*coat)) {
      for (std::size_t i = 0; i < points.size; ++i) {
        light[i] *= layer.color.passed;
        if (caustics != 0.0) light[i] *= gathered(points.normal.vector(i), points.direction.vector(i), caustics);
      }
    }
    return;
  }
  scratch.clear();
  unfold(texture, points, scratch);
  if (nodes_[roots_[texture]].coat != nullptr) return filter_by(scratch[0], light, caustics);
  std::array<Rgb, kRaysAtOnce> sums;
  sums.fill(Rgb(0.0f));
  for (std::size_t c = 0; c < scratch.size(); ++c) {
    CoatPoints& coat = scratch[c];
    std::array<Rgb, kRaysAtOnce> tints;
    tints.fill(Rgb(1.0f));
    filter_by(coat, tints, caustics);
    for (std::size_t k = 0; k < coat.points.size; ++k) {
      sums[coat.lane[k]] += tints[k] * static_cast<float>(coat.share[k]);
    }
  }
  for (std::size_t i = 0; i < points.size; ++i) light[i] *= sums[i];
}

}  // namespace firstlight::render
