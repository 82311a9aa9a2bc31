#pragma once

#include "render/camera/camera.h"
#include "render/math/columns.h"
#include "render/math/vec.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace firstlight::render {

/// The camera by which a scene is seen, and the size of the picture. It stands beside the frozen scene, so that another view needs
/// no other scene. Pre: the camera outlives it.
struct View {
  const Camera& camera;
  int width;  ///< pixels
  int height;
};

/// Places of a picture, side by side: across from -1/2 at its left edge to 1/2 at its right one, upwards from -1/2 at
/// its lower edge to 1/2 at its upper one. Samples of anti-aliasing may lie beyond the edges.
struct PicturePlaces {
  std::size_t size = 0;
  Column<double> across;
  Column<double> upwards;
  /// The same in picture coordinates, for kinds to which pixels mean something; and the size of the picture.
  Column<double> x;
  Column<double> y;
  int width = 0;
  int height = 0;

  /// In picture coordinates: (0, 0) is the upper left corner, (width, height) the lower right one, the middle of the
  /// first pixel (0.5, 0.5).
  void add(double at_x, double at_y, int of_width, int of_height) {
    width = of_width;
    height = of_height;
    x[size] = at_x;
    y[size] = at_y;
    across[size] = at_x / width - 0.5;
    upwards[size++] = (height - at_y) / height - 0.5;
  }
};

/// The rays through places of a picture.
struct CameraRays {
  std::uint64_t missing = 0;  ///< bits of the places that no ray leads through; their columns hold nothing
  Columns3<double> origin;
  Columns3<double> direction;  ///< not normalised
  Column<double> x;            ///< the projection's own coordinates, over which a camera's normal is laid
  Column<double> y;
};

/// Turns places of a picture into rays.
///
/// Threads  Immutable.
/// Source   POV-Ray 3.7 manual, "Types of Projection"; which axes are normalised is POV-Ray 3.7's.
class Projection {
 public:
  virtual ~Projection() = default;
  /// Replaces `rays` by those of `places`.
  virtual void project(const PicturePlaces& places, CameraRays& rays) const = 0;
  /// A box about the origins of all rays; one point where they begin in one.
  virtual Box3 origins() const = 0;

  /// A place may have several rays: those there are have equal shares of its light. project() gives the first.
  virtual int rays_per_place() const { return 1; }
  /// Replaces `rays` by the rays of that number, from 0 on. Pre: number < rays_per_place().
  virtual void project_further(int /*number*/, const PicturePlaces& places, CameraRays& rays) const {
    project(places, rays);
  }
};
using ProjectionPtr = std::unique_ptr<const Projection>;

/// That of the camera's kind.
ProjectionPtr make_projection(const Camera& camera);

/// The ray through one place, in picture coordinates; unit direction.
std::optional<Ray> ray_through(const View& view, double x, double y);

// ---- For the kinds of camera

/// The makers of cameras.def, a file a kind or a family.
namespace projection {
#define CAMERA(kind, word, maker) ProjectionPtr maker(const Camera& camera);
#include "render/camera/cameras.def"
#undef CAMERA
}  // namespace projection

/// A ray that a formula gives, with the projection's own coordinates.
struct ProjectedRay {
  Vec3 origin;
  Vec3 direction;
  double x;
  double y;
};

constexpr double kRadiansPerDegree = 0.017453292519943295769;

/// The axes at unit length, and the lengths they had.
struct CameraAxes {
  Vec3 direction;
  Vec3 right;
  Vec3 up;
  double width;
  double height;

  explicit CameraAxes(const Camera& camera)
      : direction(unit(camera.direction)),
        right(unit(camera.right)),
        up(unit(camera.up)),
        width(camera.right.length()),
        height(camera.up.length()) {}
};

/// A projection by a formula: (across, upwards) -> std::optional<ProjectedRay>.
template <class Formula>
class FormulaProjection final : public Projection {
 public:
  FormulaProjection(const Box3& origins, Formula formula) : origins_(origins), formula_(std::move(formula)) {}

  void project(const PicturePlaces& places, CameraRays& rays) const override {
    rays.missing = 0;
    for (std::size_t i = 0; i < places.size; ++i) {
      const std::optional<ProjectedRay> ray = formula_(places.across[i], places.upwards[i]);
      if (!ray) {
        rays.missing |= std::uint64_t{1} << i;
        continue;
      }
      rays.origin.set(i, ray->origin);
      rays.direction.set(i, ray->direction);
      rays.x[i] = ray->x;
      rays.y[i] = ray->y;
    }
  }
  Box3 origins() const override { return origins_; }

 private:
  Box3 origins_;
  Formula formula_;
};

/// All rays begin at the camera's location.
template <class Formula>
ProjectionPtr from_one_place(const Camera& camera, Formula formula) {
  return std::make_unique<FormulaProjection<Formula>>(Box3(camera.location), std::move(formula));
}

/// Rays begin at location + a `side1` + b `side2`, a and b within what places of a picture may be: a pixel beyond its
/// edges, of a picture that may be one pixel wide.
template <class Formula>
ProjectionPtr from_many_places(const Camera& camera, const Vec3& side1, const Vec3& side2, Formula formula) {
  constexpr double kFarthest = 1.5;
  Box3 origins(camera.location);
  for (const double a : {-kFarthest, kFarthest}) {
    for (const double b : {-kFarthest, kFarthest}) origins.extendBy(camera.location + side1 * a + side2 * b);
  }
  return std::make_unique<FormulaProjection<Formula>>(origins, std::move(formula));
}

}  // namespace firstlight::render
