#pragma once

#include "render/feature/feature.h"
#include "render/lanes/math.h"
#include "render/light/light_kind.h"
#include "render/math/color.h"
#include "render/math/transform.h"
#include "render/math/vec.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace firstlight::render {

struct Object;

/// A light spread over a parallelogram around its position, as a grid of points.
struct AreaLight {
  Vec3 axis1{0.0, 0.0, 1.0};  ///< edges of the parallelogram
  Vec3 axis2{0.0, 1.0, 0.0};
  int size1 = 1;  ///< points along each edge
  int size2 = 1;

  std::size_t points() const { return static_cast<std::size_t>(size1) * static_cast<std::size_t>(size2); }
};

/// A light that shines in all directions, or as the further members say. Plain data.
/// Source   POV-Ray 3.7 manual, "Light Source".
struct Light {
  Vec3 position{0.0, 0.0, 0.0};
  Rgb color{1.0f, 1.0f, 1.0f};
  bool shadowless = false;     ///< lights without being blocked, and gives no highlights
  bool unblocked = false;      ///< lights without being blocked, whatever it is projected through
  double fade_distance = 0.0;  ///< scene units
  double fade_power = 0.0;     ///< 0: no fading

  LightKind kind = LightKind::point;
  bool parallel = false;         ///< all rays have the direction from `position` to `point_at`
  Vec3 point_at{0.0, 0.0, 1.0};  ///< where the beam's axis leads
  /// Full light within `radius` of the axis, none beyond `falloff`. Units: degrees of a spot, scene units of a
  /// cylinder.
  double radius = 0.0;
  double falloff = 0.0;
  double tightness = 0.0;  ///< exponent of the cosine to the axis

  std::optional<AreaLight> area = {};
  // The rest is of area lights; without one it means nothing.
  bool jitter = false;
  bool circular = false;
  bool orient = false;             ///< turned towards the point that is lit
  bool area_illumination = false;  ///< each point lights for itself, not only casts its shadow
  int adaptive = 100;              ///< least subdivisions before more points are left out

  bool media_attenuation = false;              ///< weakened by media
  bool media_interaction = true;               ///< lights media
  std::optional<bool> photon_reflection = {};  ///< of photons; not given: as the objects have it
  std::optional<bool> photon_refraction = {};
  bool photon_area_light = false;  ///< photons start from all over the area

  std::uint32_t group = 0;           ///< of a scene: the light group whose members alone it shines on; 0: all others
  std::uint32_t window = kNoWindow;  ///< of a scene: into Scene::windows, what it is projected through
  static constexpr std::uint32_t kNoWindow = 0xffffffffu;

  std::shared_ptr<const Object> looks_like = {};         ///< in the space around the light; casts no shadow
  std::shared_ptr<const Object> projected_through = {};  ///< the same: light is only where it has come through this
  FeatureUses unrendered = {};
};

/// The way from a point to a light. Feelers that go to one light go where their light has come from.
struct LightAim {
  Vec3 direction;  ///< unit; zero in the light itself
  double depth;    ///< along the direction; below 0 behind a parallel light, which shines there and is not blocked
};

/// From `point` to a light that is at `place`: its position, or a point of its area.
inline LightAim aim_at(const Light& light, const Vec3& place, const Vec3& point) {
  const Vec3 way = place - point;
  if (light.parallel) {
    const Vec3 axis = unit(place - light.point_at);
    return {axis, way.dot(axis)};
  }
  const double distance = way.length();
  return {distance > 0.0 ? way * (1.0 / distance) : Vec3(0.0), distance};
}

/// How far a feeler from `point` reaches.
inline double reach_to(const Light& light, const Vec3& point) {
  return std::max(0.0, aim_at(light, light.position, point).depth);
}

/// Whether a feeler leads to one point, wherever it begins, and is blocked by whatever is on its way.
inline bool is_one_point(const Light& light) {
  return !light.parallel && !light.area && light.window == Light::kNoWindow;
}

/// Whether the light is added without asking what is on its way.
inline bool is_sure(const Light& light) {
  return light.unblocked || (light.shadowless && light.window == Light::kNoWindow);
}

/// Whether each point of the light's area lights for itself, and not only casts its shadow.
inline bool has_spread_light(const Light& light) { return light.area && light.area_illumination; }

/// Whether the light shines on surfaces from behind, too, if nothing is in its way: it was to light by its area, and
/// has none. [POV-Ray 3.7]
inline bool lights_both_sides(const Light& light) { return light.area_illumination && !light.area; }

/// Whether the light is weaker far away.
inline bool fades(const Light& light) {
  constexpr double kShortestFade = 1e-10;
  return light.fade_power > 0.0 && std::abs(light.fade_distance) > kShortestFade;
}

/// Share of the full light at a distance: 2 / (1 + (d / fade_distance)^fade_power), at most twice the full light.
/// [POV-Ray 3.7 manual, "Light Fading"]
inline double fading(const Light& light, double distance) {
  if (!fades(light)) return 1.0;
  return 2.0 / (1.0 + steady::power(distance / light.fade_distance, light.fade_power));
}

/// The light moved on; the objects that belong to it are the caller's to move (see render/scene/object.h).
Light placed(const Light& light, const Transform& transform);

}  // namespace firstlight::render
