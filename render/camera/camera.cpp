#include "render/camera/camera.h"

#include "render/lanes/math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace firstlight::render {
namespace {

/// A vector none of whose components exceeds this has no direction: vectors whose cross product it is are parallel.
/// [POV-Ray 3.7]
constexpr double kParallel = 1e-10;

}  // namespace

void look_at(Camera& camera, const Vec3& target) {
  const double direction_length = camera.direction.length();
  const double up_length = camera.up.length();
  const double right_length = camera.right.length();
  const bool left_handed = camera.up.cross(camera.direction).dot(camera.right) > 0.0;

  const Vec3 forward = unit(target - camera.location);
  Vec3 sideways = camera.sky.cross(forward);
  // Looking straight along the sky vector leaves open where up is: `right` decides then.
  if (std::max({std::abs(sideways.x), std::abs(sideways.y), std::abs(sideways.z)}) < kParallel) sideways = camera.right;
  sideways = unit(sideways);

  camera.direction = forward * direction_length;
  camera.right = sideways * (left_handed ? right_length : -right_length);
  camera.up = forward.cross(sideways) * up_length;
}

void set_angle(Camera& camera, double degrees) {
  const double half = degrees * (std::numbers::pi / 360.0);
  camera.direction = unit(camera.direction) * (0.5 * camera.right.length() / steady::tangent(half));
}

void widen_to_look_at(Camera& camera) {
  const double target_distance = (camera.look_at - camera.location).length();
  const double plane_distance = camera.direction.length();
  if (target_distance <= kParallel || plane_distance <= kParallel) return;
  camera.right *= target_distance / plane_distance;
  camera.up *= target_distance / plane_distance;
}

double farthest_sight(const Camera& camera) {
  constexpr double kLeast = 1e-10;  // [POV-Ray 3.7]
  const bool is_limited = camera.kind == CameraKind::mesh && camera.mesh.max_ray_distance >= kLeast;
  return is_limited ? camera.mesh.max_ray_distance : std::numeric_limits<double>::infinity();
}

void place(Camera& camera, const Transform& transform) {
  camera.location = transform.point(camera.location);
  camera.direction = transform.direction(camera.direction);
  camera.right = transform.direction(camera.right);
  camera.up = transform.direction(camera.up);
}

}  // namespace firstlight::render
