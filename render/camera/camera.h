#pragma once

#include "render/camera/camera_kind.h"
#include "render/feature/feature.h"
#include "render/math/transform.h"
#include "render/math/vec.h"

#include <memory>
#include <vector>

namespace firstlight::render {

struct Normal;
struct Pigment;
class Shape;

/// Depth of field. It shows with an aperture and samples.
struct FocalBlur {
  double aperture = 0.0;
  int samples = 0;      ///< most rays a pixel
  int min_samples = 0;  ///< least rays a pixel before `confidence` is asked
  double confidence = 0.9;
  double variance = 1e-4;
  Vec3 focal_point{0.0, 0.0, 1.0};
  double focal_distance = -1.0;               ///< from the location; below 0 only while the camera is being described
  std::shared_ptr<const Pigment> bokeh = {};  ///< over the unit square: the aperture's shape and colour; null: a disc

  bool shows() const { return aperture != 0.0 && samples > 0; }
};

/// A camera whose rays start on faces. [POV-Ray 3.7 manual, "Mesh Camera"]
struct MeshCamera {
  int rays_per_pixel = 1;
  int distribution = 0;           ///< method of dealing faces to pixels, 0 to 3
  double max_ray_distance = 0.0;  ///< 0: none
  bool smooth = false;            ///< of method 3: directions are interpolated normals
  std::vector<std::shared_ptr<const Shape>> meshes = {};
};

/// A camera as POV-Ray keeps it after its modifiers have been applied in order. The picture plane of a perspective
/// camera is spanned by `right` and `up` around `location + direction`; the lengths matter.
/// Defaults are POV-Ray 3.7's.
struct Camera {
  CameraKind kind = CameraKind::perspective;
  Vec3 location{0.0, 0.0, 0.0};
  Vec3 direction{0.0, 0.0, 1.0};
  Vec3 right{1.33, 0.0, 0.0};
  Vec3 up{0.0, 1.0, 0.0};
  Vec3 sky{0.0, 1.0, 0.0};
  Vec3 look_at{0.0, 0.0, 1.0};
  double angle = 90.0;              ///< degrees; perspective and orthographic cameras have it in `direction` already
  double horizontal_angle = 360.0;  ///< degrees, of a spherical camera
  double vertical_angle = 180.0;
  FocalBlur blur = {};
  std::shared_ptr<const Normal> normal = {};  ///< over the picture: it turns the rays; null: none
  MeshCamera mesh = {};
  FeatureUses unrendered = {};
};

/// Turns the camera towards a point, keeping the lengths (and handedness) of its axes, sky upwards.
void look_at(Camera& camera, const Vec3& target);
/// Sets the length of `direction` so that `right` spans `degrees`; pre: 0 < degrees < 180.
void set_angle(Camera& camera, double degrees);
/// Makes an orthographic camera's picture plane as large as it looks at the distance of `look_at`.
void widen_to_look_at(Camera& camera);
void place(Camera& camera, const Transform& transform);
/// How far rays see that begin at the camera; infinity for most.
double farthest_sight(const Camera& camera);

}  // namespace firstlight::render
