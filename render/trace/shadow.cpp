#include "render/trace/shadow.h"

#include "render/math/interrupt.h"
#include "render/trace/fade.h"
#include "render/trace/shape_runs.h"
#include "render/trace/worn_textures.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;
constexpr double kNearestWindow = 1e-4;  ///< scene units [POV-Ray 3.7]

}  // namespace

Shadow::Shadow(const TraceContext& context, const SurfaceTable& surfaces, const Veils& veils)
    : context_(context),
      surfaces_(surfaces),
      veils_(veils),
      takes_parts_(std::ranges::any_of(context.scene.parts, [](const Part& part) { return !part.opaque; }) ||
                   std::ranges::any_of(context.scene.lights, [&](const Light& light) { return veils.weaken(light); })),
      see_through_(context.scene),
      met_(std::make_unique_for_overwrite<SurfacePlaces>()),
      asked_(std::make_unique_for_overwrite<SurfacePoints>()),
      block_(std::make_unique<RayBlock>()) {}

bool Shadow::end_at_window(const Light& light, const Ray& ray, double& max_depth) {
  if (light.window == Light::kNoWindow) return true;
  crossings_.clear();
  context_.scene.windows[light.window].crossings(ray, 0, crossings_);
  double nearest = INFINITY;
  for (const Crossing& crossing : crossings_) {
    if (crossing.depth > kNearestWindow) nearest = std::min(nearest, crossing.depth);
  }
  if (!(nearest < max_depth + kShadowGap)) return false;
  max_depth = light.shadowless ? 0.0 : nearest - kShadowGap;
  return true;
}

void Shadow::passing(const RayBlock& rays, std::span<const std::uint32_t> media, std::span<const std::uint32_t> lights,
                     std::span<Rgb> shares) {
  const std::uint64_t blocked = context_.accel.occluded(rays);
  std::ranges::fill(shares, Rgb(1.0f));
  for (std::uint64_t bits = blocked; bits != 0; bits &= bits - 1) {
    shares[static_cast<std::size_t>(std::countr_zero(bits))] = Rgb(0.0f);
  }
  if (takes_parts_) pass_surfaces(rays, rays.all() & ~blocked, media, lights, shares);
}

// Surface after surface, all rays together: each round finds the next one of every ray that goes on.
void Shadow::pass_surfaces(const RayBlock& rays, std::uint64_t open, std::span<const std::uint32_t> media,
                           std::span<const std::uint32_t> lights, std::span<Rgb> shares) {
  ways_.clear();
  for (; open != 0; open &= open - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(open));
    const Light& light = context_.scene.lights[lights[i]];
    Way way{i, rays.ray(i), rays.max_depth[i] + kShadowGap, media[i], veils_.weaken(light), Rgb(1.0f)};
    if (see_through_.may_lie_on(way.ray)) {
      ways_.push_back(way);
    } else {
      shares[i] = arriving(way);
    }
  }
  RayBlock& block = *block_;
  while (!ways_.empty() && !Interrupt::asked()) {
    block.size = 0;
    keep_ways([&](Way& way) {
      if (!(way.distance > 2.0 * kShadowGap) || is_black(way.passed)) {
        shares[way.number] = arriving(way);
        return false;
      }
      const std::size_t k = block.size++;
      block.origin.set(k, way.ray.origin);
      block.direction.set(k, way.ray.direction);
      block.min_depth[k] = kShadowGap;
      block.max_depth[k] = way.distance - kShadowGap;
      block.hidden_bit[k] = kHiddenFromShadow;
      return true;
    });
    context_.accel.closest(block, hits_);
    const Hit* hit = hits_.data();
    std::size_t met = 0;
    keep_ways([&](Way& way) {
      const Hit& next = *hit++;
      if (next.part == kNoIndex) {
        shares[way.number] = arriving(way);
        return false;
      }
      if (context_.scene.parts[next.part].opaque) {
        shares[way.number] = Rgb(0.0f);  // was nearer than the gap to the origin before the ray moved on
        return false;
      }
      met_->point.set(met, way.ray.at(next.depth));
      met_->crossing[met++] = &next;
      return true;
    });
    pass();
  }
}

template <class Keep>
void Shadow::keep_ways(const Keep& keep) {
  std::size_t kept = 0;
  for (Way& way : ways_) {
    if (keep(way)) ways_[kept++] = way;
  }
  ways_.resize(kept);
}

void Shadow::pass_fog(Way& way, double depth) const {
  if (way.through_fog && is_hollow(context_.scene, context_.media, way.medium)) {
    way.passed *= veils_.left_of_light(way.ray, depth);
  }
}

Rgb Shadow::arriving(Way& way) const {
  pass_fog(way, way.distance);
  return way.passed;
}

void Shadow::pass() {
  MediumTable& media = context_.media;
  const std::uint64_t filtered = filter_light();
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    Way& way = ways_[i];
    const double depth = met_->crossing[i]->depth;
    const std::uint32_t own = part_at(i).interior;
    const bool is_inside = media.contains(way.medium, own);
    if ((filtered >> i & 1u) != 0) {
      const Interior& interior = context_.scene.interiors[own];
      if (interior.fade_power > 0.0 && std::abs(interior.fade_distance) > kNegligible && is_inside) {
        way.passed *= faded_light(interior, depth);
      }
    }
    pass_fog(way, depth);
    way.medium = is_inside ? media.left(way.medium, own) : media.entered(way.medium, own);
    way.distance -= depth;
    way.ray.origin = met_->point.vector(i);
  }
}

std::uint64_t Shadow::filter_light() {
  const auto [done, shared] = find_filters();
  std::uint64_t found = done | shared;
  if (found == done && filters_.empty()) return found;
  const auto key = [&](std::uint32_t number) {
    const Filter& filter = filters_[number];
    return std::tuple(filter.texture, filter.caustics, number);
  };
  std::ranges::sort(order_, {}, key);
  for (std::size_t first = 0; first < order_.size();) {
    const Filter& filter = filters_[order_[first]];
    const auto is_alike = [&](std::uint32_t other) {
      return filters_[other].texture == filter.texture && filters_[other].caustics == filter.caustics;
    };
    std::size_t end = first + 1;
    while (end < order_.size() && end - first < kRaysAtOnce && is_alike(order_[end])) ++end;
    ask_filters(std::span(order_).subspan(first, end - first));
    first = end;
  }

  std::array<Rgb, kRaysAtOnce> sums;
  if (shared != 0) sums.fill(Rgb(0.0f));
  for (const Filter& filter : filters_) {
    if ((shared >> filter.way & 1u) != 0) {
      sums[filter.way] += filter.passed * static_cast<float>(filter.share);
    } else {
      ways_[filter.way].passed = filter.passed;
      found |= std::uint64_t{1} << filter.way;
    }
  }
  for (std::uint64_t bits = shared; bits != 0; bits &= bits - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(bits));
    ways_[i].passed *= sums[i];
  }
  return found;
}

Shadow::Sides Shadow::find_filters() {
  const auto find_normals = [&](std::uint64_t which) {
    for_each_run(*met_, which, [&](const Shape& shape, std::size_t first, std::size_t end) {
      shape.normals(*met_, first, end, normals_);
    });
  };
  std::uint64_t has_two_sides = 0;
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    if (part_at(i).interior_texture != kNoIndex) has_two_sides |= std::uint64_t{1} << i;
  }
  find_normals(has_two_sides);

  filters_.clear();
  order_.clear();
  std::uint64_t by_surface = 0;
  std::uint64_t by_uv = 0;
  const auto add = [&](std::size_t i, std::uint32_t texture, double share, bool is_even, const Rgb& passed) {
    const Part& part = part_at(i);
    const double caustics = context_.scene.interiors[part.interior]->caustics;
    filters_.push_back(Filter{texture, static_cast<std::uint8_t>(i), part.uv_mapping, share, caustics, passed});
    if (is_even) return;
    order_.push_back(static_cast<std::uint32_t>(filters_.size() - 1));
    const auto bit = [i](bool is_set) { return static_cast<std::uint64_t>(is_set) << i; };
    by_surface |= bit(caustics != 0.0 || surfaces_.goes_by_surface(texture));
    by_uv |= bit(part.uv_mapping || surfaces_.goes_by_uv(texture));
  };
  const auto filter_evenly = [&](std::size_t i, std::uint32_t texture, Rgb& light) {
    return context_.scene.interiors[part_at(i).interior]->caustics == 0.0 && surfaces_.filter_evenly(texture, light);
  };
  std::uint64_t has_own = 0;
  Sides sides;
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    const Part& part = part_at(i);
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (part.has_shape_textures) sides.shared |= bit;
    const bool from_inside = (has_two_sides & bit) != 0 && normals_.vector(i).dot(ways_[i].ray.direction) > 0.0;
    if (shows_own_textures(part, from_inside)) {
      has_own |= bit;
      continue;
    }
    const std::uint32_t texture = only_texture(part, from_inside);
    if (texture == kNoIndex) continue;
    Rgb light = part.has_shape_textures ? Rgb(1.0f) : ways_[i].passed;
    const bool is_even = filter_evenly(i, texture, light);
    if (!is_even || part.has_shape_textures) {
      add(i, texture, 1.0, is_even, light);
    } else {
      ways_[i].passed = light;
      sides.done |= bit;
    }
  }
  for_each_own_texture(context_.scene, *met_, has_own, worn_, [&](std::size_t i, std::uint32_t texture, double share) {
    Rgb tint(1.0f);
    const bool is_even = filter_evenly(i, texture, tint);
    add(i, texture, share, is_even, tint);
  });
  find_normals(by_surface & ~has_two_sides);
  for_each_run(*met_, by_uv,
               [&](const Shape& shape, std::size_t first, std::size_t end) { shape.uvs(*met_, first, end, uvs_); });
  return sides;
}

void Shadow::ask_filters(std::span<const std::uint32_t> numbers) {
  const std::uint32_t texture = filters_[numbers.front()].texture;
  const double caustics = filters_[numbers.front()].caustics;
  SurfacePoints& points = *asked_;
  points.size = numbers.size();
  points.on_surface = caustics != 0.0 || surfaces_.goes_by_surface(texture);
  const bool asks_uv = surfaces_.goes_by_uv(texture);
  std::array<Rgb, kRaysAtOnce> light;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const Filter& filter = filters_[numbers[k]];
    const std::size_t i = filter.way;
    const Vec3 point = met_->point.vector(i);
    points.at.set(k, point);
    if (points.on_surface) {
      const Vec3& direction = ways_[i].ray.direction;
      const Vec3 outward = normals_.vector(i);
      const Vec3 normal = outward.dot(direction) > 0.0 ? -outward : outward;
      points.place.set(k, point);
      points.normal.set(k, normal);
      points.tilted.set(k, normal);
      points.direction.set(k, direction);
      points.uv.set(k, Vec2(0.0));
    }
    if (asks_uv || filter.follows_uv) {
      const Vec2 uv = uvs_.vector(i);
      points.uv.set(k, uv);
      if (filter.follows_uv) points.at.set(k, Vec3(uv.x, uv.y, 0.0));
    }
    light[k] = filter.passed;
  }
  surfaces_.filter(texture, points, std::span(light).first(numbers.size()), coats_, caustics);
  for (std::size_t k = 0; k < numbers.size(); ++k) filters_[numbers[k]].passed = light[k];
}

}  // namespace firstlight::render
