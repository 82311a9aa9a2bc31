#pragma once

#include "render/camera/projection.h"
#include "render/lanes/math.h"

#include <numbers>

namespace firstlight::render {

/// A ray `y` radians off the camera's direction, towards x radians from `right` to `up`: what the projections on a disc
/// have in common.
inline ProjectedRay ray_off_axis(const Vec3& at, const CameraAxes& axes, double x, double y) {
  return {at,
          axes.right * (steady::cosine(x) * steady::sine(y)) + axes.up * (steady::sine(x) * steady::sine(y)) +
              axes.direction * steady::cosine(y),
          x, y};
}

/// The angle of a place on the disc, from its own x axis. `radius`: of the place.
inline double angle_on_disc(double x, double y, double radius) {
  if (radius == 0.0) return 0.0;
  return x < 0.0 ? std::numbers::pi - steady::arc_sine(y / radius) : steady::arc_sine(y / radius);
}

}  // namespace firstlight::render
