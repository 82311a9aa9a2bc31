#pragma once

#include "render/math/transform.h"
#include "render/math/vec.h"
#include "render/feature/feature.h"

namespace firstlight::render {

/// A perspective camera as POV-Ray keeps it after its modifiers have been applied in order. The picture plane is
/// spanned by `right` and `up` around `location + direction`; the lengths matter.
/// Defaults are POV-Ray 3.7's.
struct Camera {
  Vec3 location{0.0, 0.0, 0.0};
  Vec3 direction{0.0, 0.0, 1.0};
  Vec3 right{1.33, 0.0, 0.0};
  Vec3 up{0.0, 1.0, 0.0};
  Vec3 sky{0.0, 1.0, 0.0};
  FeatureUses unrendered = {};
};

/// Turns the camera towards a point, keeping the lengths (and handedness) of its axes, sky upwards.
void look_at(Camera& camera, const Vec3& target);
/// Sets the length of `direction` so that `right` spans `degrees`; pre: 0 < degrees < 180.
void set_angle(Camera& camera, double degrees);
void place(Camera& camera, const Transform& transform);

/// The ray through picture coordinates: (0, 0) is the upper left corner of the picture, (width, height) the lower right
/// one; the middle of the first pixel is (0.5, 0.5). Unit direction.
Ray primary_ray(const Camera& camera, double x, double y, int width, int height);

}  // namespace firstlight::render
