#include "render/scene/object_probe.h"

#include "render/scene/extent.h"
#include "render/scene/region.h"

#include <limits>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

/// Nearer crossings are taken for the surface that the ray begins on. [POV-Ray 3.7]
constexpr double kNearest = 1e-4;

}  // namespace

ObjectProbe::ObjectProbe(const Object& object) {
  std::optional<Solid> solid = region(object, Transform(), false);
  if (!solid) return;
  if (object.cramped) solid->set_extent(extent(object));
  solid_ = std::make_shared<const Solid>(std::move(*solid));
}

std::optional<ObjectProbe::Hit> ObjectProbe::trace(const Vec3& origin, const Vec3& direction) const {
  const double length = direction.length();
  if (!solid_ || !(length > 0.0)) return std::nullopt;
  const Ray ray{origin, direction * (1.0 / length)};
  if (!meets(ray, solid_->box())) return std::nullopt;
  std::vector<Crossing> crossings;
  solid_->crossings(ray, 0, crossings);
  const Crossing* first = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Crossing& crossing : crossings) {
    if (crossing.depth < kNearest || !(crossing.depth < nearest)) continue;
    nearest = crossing.depth;
    first = &crossing;
  }
  if (first == nullptr) return std::nullopt;
  const Vec3 point = ray.at(first->depth);
  return Hit{point, first->shape->normal(point, *first)};
}

bool ObjectProbe::inside(const Vec3& point) const { return solid_ && solid_->inside(point); }

}  // namespace firstlight::render
