#include "render/trace/see_through.h"

#include "render/math/bounds.h"
#include "render/scene/scene.h"

#include <algorithm>

namespace firstlight::render {
namespace {

/// More things than that are bounded together.
constexpr std::size_t kMostBoxes = 6;

bool any_see_through(const Solid& solid, const std::vector<Part>& parts) {
  if (solid.kind == Solid::Kind::shape) return !parts[solid.part].opaque;
  return std::ranges::any_of(solid.members(), [&](const Solid& m) { return any_see_through(m, parts); });
}

}  // namespace

SeeThrough::SeeThrough(const Scene& scene) {
  Box3 all;
  for (const Solid& solid : scene.solids) {
    if ((solid.hidden_from & kHiddenFromShadow) != 0 || !any_see_through(solid, scene.parts)) continue;
    const Box3 box = solid.box();
    if (boxes_.size() <= kMostBoxes) boxes_.push_back(box);
    all.extendBy(box);
  }
  if (boxes_.size() > kMostBoxes) boxes_.assign(1, all);
}

bool SeeThrough::may_lie_on(const Ray& ray) const {
  return std::ranges::any_of(boxes_, [&](const Box3& box) { return meets(ray, box); });
}

}  // namespace firstlight::render
