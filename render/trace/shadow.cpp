#include "render/trace/shadow.h"

#include "render/math/interrupt.h"
#include "render/trace/fade.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;
constexpr double kNearestWindow = 1e-4;  ///< scene units [POV-Ray 3.7]

}  // namespace

Shadow::Shadow(const TraceContext& context, const SurfaceTable& surfaces)
    : context_(context),
      surfaces_(surfaces),
      has_transparent_casters_(std::ranges::any_of(context.scene.parts, [](const Part& part) { return !part.opaque; })),
      asked_(std::make_unique<SurfacePoints>()) {}

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

void Shadow::passing(const RayBlock& rays, std::span<const std::uint32_t> media, std::span<Rgb> shares) {
  const std::uint64_t blocked = context_.accel.occluded(rays);
  for (std::size_t i = 0; i < rays.size; ++i) {
    if ((blocked >> i & 1u) != 0) {
      shares[i] = Rgb(0.0f);
    } else if (has_transparent_casters_) {
      shares[i] = passing_light(media[i], {rays.origin.vector(i), rays.direction.vector(i)},
                                rays.max_depth[i] + kShadowGap);
    } else {
      shares[i] = Rgb(1.0f);
    }
  }
}

Rgb Shadow::passing_light(std::uint32_t medium, Ray ray, double distance) {
  const Scene& scene = context_.scene;
  MediumTable& media = context_.media;
  Rgb passed(1.0f);
  while (distance > 2.0 * kShadowGap && !is_black(passed) && !Interrupt::asked()) {
    const RayQuery query{ray, kShadowGap, distance - kShadowGap, kHiddenFromShadow};
    Hit hit;
    context_.accel.closest({&query, 1}, {&hit, 1});
    if (hit.part == kNoIndex) break;
    const Part& part = scene.parts[hit.part];
    if (part.opaque) return Rgb(0.0f);  // was nearer than the gap to the origin before the ray moved on
    const Vec3 point = ray.at(hit.depth);
    if (filter_light(hit, ray, passed)) {
      const Interior& interior = scene.interiors[part.interior];
      if (interior.fade_power > 0.0 && std::abs(interior.fade_distance) > kNegligible &&
          media.contains(medium, part.interior)) {
        passed *= faded_light(interior, hit.depth);
      }
    }
    medium = media.contains(medium, part.interior) ? media.left(medium, part.interior)
                                                   : media.entered(medium, part.interior);
    distance -= hit.depth;
    ray.origin = point;
  }
  return passed;
}

bool Shadow::filter_light(const Hit& hit, const Ray& ray, Rgb& light) {
  const Part& part = context_.scene.parts[hit.part];
  const Vec3 point = ray.at(hit.depth);
  std::uint32_t texture = part.texture;
  if (part.interior_texture != kNoIndex) {
    const Vec3 normal = hit.shape->normal(point, {hit.depth, hit.shape, hit.part, hit.face});
    if (normal.dot(ray.direction) > 0.0) texture = part.interior_texture;
  }
  if (texture == kNoIndex) return false;
  asked_->size = 1;
  asked_->at.set(0, point);
  asked_->direction.set(0, ray.direction);
  surfaces_.filter(texture, *asked_, {&light, 1});
  return true;
}

}  // namespace firstlight::render
