#pragma once

#include "render/math/vec.h"
#include "render/shape/box.h"
#include "render/shape/sphere.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <optional>
#include <variant>

namespace firstlight::render {

struct ContainerBox {
  Vec3 low{-1.0, -1.0, -1.0};
  Vec3 high{1.0, 1.0, 1.0};
};
struct ContainerSphere {
  Vec3 center{0.0, 0.0, 0.0};
  double radius = 1.0;
};
/// Where a surface that is given by functions is looked for.
using Container = std::variant<ContainerBox, ContainerSphere>;

/// The part of a ray in a container. Face 0 is a sphere; a box has 1 + those of AxisBox.
struct ContainedPart {
  double begin = 0.0;  ///< of a ray that starts in a box 0, in a sphere below 0
  double end = 0.0;
  std::uint32_t begin_face = 0;
  std::uint32_t end_face = 0;
};

/// Depths are those of the given ray, whatever its direction's length. [POV-Ray 3.7]
inline std::optional<ContainedPart> contained_part(const Container& container, const Ray& given) {
  if (const auto* sphere = std::get_if<ContainerSphere>(&container)) {
    const auto [length, ray] = UnitRay(given);
    double enters;
    double leaves;
    if (!meet_sphere(ray, sphere->center, sphere->radius * sphere->radius, enters, leaves)) return std::nullopt;
    return ContainedPart{enters / length, leaves / length, 0, 0};
  }
  const auto& box = std::get<ContainerBox>(container);
  BoxMet met;
  AxisBox{box.low, box.high}.meet(given, met);
  if (met.count == 0) return std::nullopt;
  if (met.count == 1) return ContainedPart{0.0, met.depth[0], 0, 1 + met.face[0]};
  return ContainedPart{met.depth[0], met.depth[1], 1 + met.face[0], 1 + met.face[1]};
}

inline bool holds(const Container& container, const Vec3& point) {
  if (const auto* sphere = std::get_if<ContainerSphere>(&container)) {
    return (sphere->center - point).length2() <= sphere->radius * sphere->radius;
  }
  const auto& box = std::get<ContainerBox>(container);
  return Box3(box.low, box.high).intersects(point);
}

inline Box3 bounds_of(const Container& container) {
  if (const auto* sphere = std::get_if<ContainerSphere>(&container)) {
    const Vec3 reach(std::abs(sphere->radius));
    return Box3(sphere->center - reach, sphere->center + reach);
  }
  const auto& box = std::get<ContainerBox>(container);
  return Box3(box.low, box.high);
}

}  // namespace firstlight::render
