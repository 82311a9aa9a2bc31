#include "render/trace/shadow.h"

#include "render/math/interrupt.h"
#include "render/trace/fade.h"
#include "render/trace/worn_textures.h"

#include <algorithm>
#include <bit>
#include <cmath>

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
      asked_(std::make_unique<SurfacePoints>()),
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
    ways_.push_back(Way{i, {rays.origin.vector(i), rays.direction.vector(i)}, rays.max_depth[i] + kShadowGap, media[i],
                        veils_.weaken(light), Rgb(1.0f)});
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
      pass(next, way);
      return true;
    });
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

void Shadow::pass(const Hit& hit, Way& way) {
  MediumTable& media = context_.media;
  const std::uint32_t own = context_.scene.parts[hit.part].interior;
  const bool is_inside = media.contains(way.medium, own);
  const Vec3 point = way.ray.at(hit.depth);
  if (filter_light(hit, way.ray, way.passed)) {
    const Interior& interior = context_.scene.interiors[own];
    if (interior.fade_power > 0.0 && std::abs(interior.fade_distance) > kNegligible && is_inside) {
      way.passed *= faded_light(interior, hit.depth);
    }
  }
  pass_fog(way, hit.depth);
  way.medium = is_inside ? media.left(way.medium, own) : media.entered(way.medium, own);
  way.distance -= hit.depth;
  way.ray.origin = point;
}

bool Shadow::filter_light(const Hit& hit, const Ray& ray, Rgb& light) {
  const Part& part = context_.scene.parts[hit.part];
  const Vec3 point = ray.at(hit.depth);
  const bool from_inside =
      part.interior_texture != kNoIndex && hit.shape->normal(point, hit).dot(ray.direction) > 0.0;
  const double caustics = context_.scene.interiors[part.interior]->caustics;
  bool found = part.has_shape_textures;
  Rgb sum(0.0f);
  for_each_texture(context_.scene, point, hit, from_inside, worn_, [&](std::uint32_t texture, double share) {
    found = true;
    ask_at(hit, point, ray, part.uv_mapping || caustics != 0.0 || surfaces_.goes_by_surface(texture));
    if (part.uv_mapping) asked_->at.set(0, Vec3(asked_->u[0], asked_->v[0], 0.0));
    if (!part.has_shape_textures) return surfaces_.filter(texture, *asked_, {&light, 1}, coats_, caustics);
    Rgb tint(1.0f);
    surfaces_.filter(texture, *asked_, {&tint, 1}, coats_, caustics);
    sum += tint * static_cast<float>(share);
  });
  if (part.has_shape_textures) light *= sum;
  return found;
}

void Shadow::ask_at(const Crossing& crossing, const Vec3& point, const Ray& ray, bool whole) {
  asked_->size = 1;
  asked_->at.set(0, point);
  asked_->direction.set(0, ray.direction);
  asked_->on_surface = whole;
  if (!whole) return;
  const Vec3 normal = crossing.shape->normal(point, crossing);
  asked_->place.set(0, point);
  asked_->normal.set(0, normal.dot(ray.direction) > 0.0 ? -normal : normal);
  asked_->tilted.set(0, asked_->normal.vector(0));
  const Vec2 uv = crossing.shape->uv(point, crossing);
  asked_->u[0] = uv.x;
  asked_->v[0] = uv.y;
}

}  // namespace firstlight::render
