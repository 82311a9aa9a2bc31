#include "render/texture/warp.h"

namespace firstlight::render {

void Warps::transform(const Transform& next) {
  if (next.is_identity()) return;
  if (!steps.empty()) {
    if (auto* last = std::get_if<Transform>(&steps.back())) {
      *last = last->then(next);
      return;
    }
  }
  steps.emplace_back(next);
}

Vec3 Warps::to_pattern(const Vec3& point) const {
  Vec3 there = point;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    if (const auto* transform = std::get_if<Transform>(&*step)) there = transform->inverse_point(there);
  }
  return there;
}

}  // namespace firstlight::render
