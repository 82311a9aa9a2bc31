#include "render/light/light.h"

#include <cmath>

namespace firstlight::render {
namespace {

/// Shorter fade distances count as none. [POV-Ray 3.7]
constexpr double kShortestFade = 1e-10;

/// 2 / (1 + (d / fade_distance)^fade_power): the full light at the fade distance, at most twice as much nearer.
/// [POV-Ray 3.7 manual, "Light Fading"]
double faded(const Light& light, double distance) {
  if (!(light.fade_power > 0.0) || std::abs(light.fade_distance) <= kShortestFade) return 1.0;
  return 2.0 / (1.0 + std::pow(distance / light.fade_distance, light.fade_power));
}

}  // namespace

Illumination illuminate(const Light& light, const Vec3& point) {
  Illumination result;
  result.direction = light.position - point;
  result.distance = result.direction.length();
  // In the light itself no direction is towards it; the zero vector gives no light.
  if (result.distance > 0.0) result.direction /= result.distance;
  const double share = faded(light, result.distance);
  result.color = {static_cast<float>(light.color.x * share), static_cast<float>(light.color.y * share),
                  static_cast<float>(light.color.z * share)};
  return result;
}

Light placed(const Light& light, const Transform& transform) {
  Light moved = light;
  moved.position = transform.point(light.position);
  return moved;
}

}  // namespace firstlight::render
