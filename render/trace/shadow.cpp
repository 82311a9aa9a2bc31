#include "render/trace/shadow.h"

#include "render/math/interrupt.h"
#include "render/trace/fade.h"
#include "render/trace/worn_textures.h"

#include <algorithm>
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

void Shadow::passing(const RayBlock& rays, std::span<const std::uint32_t> media, std::span<const std::uint32_t> lights,
                     std::span<Rgb> shares) {
  const std::uint64_t blocked = context_.accel.occluded(rays);
  for (std::size_t i = 0; i < rays.size; ++i) {
    if ((blocked >> i & 1u) != 0) {
      shares[i] = Rgb(0.0f);
    } else if (takes_parts_) {
      shares[i] = passing_light(context_.scene.lights[lights[i]], media[i],
                                {rays.origin.vector(i), rays.direction.vector(i)}, rays.max_depth[i] + kShadowGap);
    } else {
      shares[i] = Rgb(1.0f);
    }
  }
}

Rgb Shadow::passing_light(const Light& light, std::uint32_t medium, Ray ray, double distance) {
  const Scene& scene = context_.scene;
  MediumTable& media = context_.media;
  Rgb passed(1.0f);
  const bool through_fog = veils_.weaken(light);
  const auto pass_fog = [&](double depth) {
    if (through_fog && is_hollow(scene, media, medium)) passed *= veils_.left_of_light(ray, depth);
  };
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
    pass_fog(hit.depth);
    medium = media.contains(medium, part.interior) ? media.left(medium, part.interior)
                                                   : media.entered(medium, part.interior);
    distance -= hit.depth;
    ray.origin = point;
  }
  pass_fog(distance);
  return passed;
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
