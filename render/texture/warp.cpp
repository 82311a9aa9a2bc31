#include "render/texture/warp.h"

#include <algorithm>

namespace firstlight::render {
namespace {

/// Patterns are evaluated no farther from their origin than this. [POV-Ray 3.7]
constexpr double kFarthest = 1e17;

Vec3 moved(const Turbulence& turbulence, const Vec3& point) {
  return point + dturbulence(point, octaves_of(turbulence)) * turbulence.amount;
}

// The point before a warp for one behind it. [POV-Ray 3.7]
Vec3 unwarped(const Transform& transform, const Vec3& point) { return transform.inverse_point(point); }
Vec3 unwarped(const Turbulence& turbulence, const Vec3& point) { return moved(turbulence, point); }
template <class NotRendered>
Vec3 unwarped(const NotRendered&, const Vec3& point) {
  return point;
}

}  // namespace

Octaves octaves_of(const Turbulence& turbulence) {
  return {turbulence.octaves, static_cast<float>(turbulence.lambda), static_cast<float>(turbulence.omega)};
}

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

Vec3 Warps::to_pattern(const Vec3& point, bool moves) const {
  Vec3 there = point;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    there = std::visit([&](const auto& warp) { return unwarped(warp, there); }, *step);
  }
  if (turbulence && moves) there = moved(*turbulence, there);
  const auto within = [](double x) { return std::clamp(x, -kFarthest, kFarthest); };
  return {within(there.x), within(there.y), within(there.z)};
}

Vec3 Warps::normal_to_pattern(const Vec3& normal) const {
  Vec3 there = normal;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    if (const auto* transform = std::get_if<Transform>(&*step)) there = transform->inverse().normal(there);
  }
  return there;
}

Vec3 Warps::normal_from_pattern(const Vec3& normal) const {
  Vec3 here = normal;
  for (const Warp& step : steps) {
    if (const auto* transform = std::get_if<Transform>(&step)) here = transform->normal(here);
  }
  return here;
}

}  // namespace firstlight::render
