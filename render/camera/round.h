#pragma once

#include "render/camera/projection.h"

#include <numbers>

namespace firstlight::render {

/// A ray `y` radians off the camera's direction, towards x radians from `right` to `up`: what the projections on a disc
/// have in common.
inline ProjectedRay ray_off_axis(const Vec3& at, const CameraAxes& axes, double x, double y) {
  return {
      at,
      axes.right * (std::cos(x) * std::sin(y)) + axes.up * (std::sin(x) * std::sin(y)) + axes.direction * std::cos(y),
      x, y};
}

/// The angle of a place on the disc, from its own x axis. `radius`: of the place.
inline double angle_on_disc(double x, double y, double radius) {
  if (radius == 0.0) return 0.0;
  return x < 0.0 ? std::numbers::pi - std::asin(y / radius) : std::asin(y / radius);
}

}  // namespace firstlight::render
