#pragma once

#include "render/math/bounds.h"
#include "render/math/ray_columns.h"
#include "render/math/transform.h"
#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace firstlight::render {

class Shape;
class Slots;

/// One point where a ray passes through a surface.
struct Crossing {
  double depth = 0.0;  ///< along the ray, in its units
  const Shape* shape = nullptr;
  std::uint32_t part = 0;         ///< index into Scene::parts; set by the solid that owns the shape
  std::uint32_t face = 0;         ///< the shape's own note: which side, cap or triangle was met
  std::array<double, 2> place{};  ///< likewise: where on the face, a curve's parameter, say
};

/// Places on surfaces, side by side: crossings, and the points where they lie.
struct SurfacePlaces {
  Columns3<double> point;
  std::array<const Crossing*, kRaysAtOnce> crossing;
};

/// A texture that a shape shows at one of some places, and its share of how the shape looks there.
struct TextureShare {
  std::uint32_t place = 0;
  std::uint32_t texture = 0;  ///< in the shape's own list; kObjectTexture: the object's
  double weight = 1.0;
};
constexpr std::uint32_t kObjectTexture = 0xffffffffu;

/// The geometry of one primitive, placed in world space. Immutable; shared between copies of an object.
///
/// Order    Crossings may be appended in any order; equal input gives equal output, bit for bit.
/// Threads  All members may be called from any thread.
/// Source   Tolerances and the meaning of "inside" are POV-Ray 3.7's.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Appends every crossing in front of the ray's origin that POV-Ray's own test for this shape would report.
  virtual void crossings(const Ray& ray, std::vector<Crossing>& out) const = 0;
  /// The same of a ray of which only the nearest crossing beyond `low` counts: that one, if it lies below `high`, is
  /// appended, with all that are as near; others may be left out.
  virtual void nearest(const Ray& ray, double /*low*/, double /*high*/, std::vector<Crossing>& out) const {
    crossings(ray, out);
  }
  /// Whether `point` is in the solid. An `inverse` shape is the complement.
  virtual bool inside(const Vec3& point) const = 0;
  /// Adds slots with what crossings() tells of those rays of a block whose bits are in `who`; or, if the window is
  /// given, with what nearest() tells of them. When there is no room for a slot, the rest is left out.
  virtual void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                          Slots& slots) const;
  /// Returns the bits of those points in `who` that are in the solid.
  virtual std::uint64_t inside_block(const Columns3<double>& points, std::uint64_t who) const;
  /// Whether the two work on many rays and points at once, and not on one after the other.
  virtual bool is_over_lanes() const { return false; }
  /// Unit outward normal at a crossing that this shape reported. Inverted shapes point inwards.
  virtual Vec3 normal(const Vec3& point, const Crossing& crossing) const = 0;
  /// The same at the points `first` to `end`, at each of which its crossing was reported.
  virtual void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const {
    for (std::size_t i = first; i < end; ++i) out.set(i, normal(places.point.vector(i), *places.crossing[i]));
  }
  /// Coordinates of the surface's own at a crossing, by which textures may go (uv_mapping). A shape that has none gives
  /// x and y of the point, as POV-Ray does.
  virtual Vec2 uv(const Vec3& point, const Crossing&) const { return Vec2(point.x, point.y); }
  /// The same at the points `first` to `end`.
  virtual void uvs(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns2<double>& out) const {
    for (std::size_t i = first; i < end; ++i) out.set(i, uv(places.point.vector(i), *places.crossing[i]));
  }
  /// Appends the textures that are seen at the crossings `first` to `end`, place by place, of a shape that has a list of
  /// its own. At each place their weights add up to 1.
  virtual void textures(const SurfacePlaces&, std::size_t first, std::size_t end,
                        std::vector<TextureShare>& out) const {
    for (std::size_t i = first; i < end; ++i) out.push_back({static_cast<std::uint32_t>(i), kObjectTexture, 1.0});
  }
  /// World box of the surface; infinite when the shape is unbounded.
  virtual Box3 bounds() const = 0;
  /// The box that POV-Ray gives it. Where a radius is negative it is too small, or turned inside out.
  virtual Box3 given_bounds() const { return bounds(); }
  /// Every point outside this box is outside the shape. Infinite for a complement or a half space; otherwise it holds
  /// bounds().
  virtual Box3 inside_bounds() const { return boundless_box(); }
  /// Every point outside this box is inside the shape. Infinite for all but complements and half spaces.
  virtual Box3 outside_bounds() const { return boundless_box(); }
  /// The same shape moved on by `transform`.
  virtual std::shared_ptr<const Shape> placed(const Transform& transform) const = 0;
  /// The complement: inside and outside exchanged, surface unchanged.
  virtual std::shared_ptr<const Shape> inverted() const = 0;
  /// Whether POV-Ray asks the shape's box whenever it asks the shape: not where the shape is asked as quickly.
  virtual bool asks_box() const { return true; }
};

using ShapePtr = std::shared_ptr<const Shape>;

}  // namespace firstlight::render
