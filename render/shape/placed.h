#pragma once

#include "render/math/transform_columns.h"
#include "render/shape/shape.h"

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace firstlight::render {

/// Takes the crossings of one primitive with one ray: depths along the ray as it was given.
class Met {
 public:
  Met(const Shape& shape, std::vector<Crossing>& out) : Met(shape, out, kBoundless) {}
  /// Only the nearest crossing beyond `low` is wanted, and only below `high`.
  Met(const Shape& shape, std::vector<Crossing>& out, double low, double high = kBoundless)
      : shape_(&shape), out_(&out), low_(low), high_(high) {}

  void add(double depth, std::uint32_t face = 0, const std::array<double, 2>& place = {}) {
    out_->push_back({depth, shape_, 0, face, place});
    is_enough_ = is_enough_ || depth > low_;
  }
  /// Whether crossings that lie behind all that were added need not be looked for.
  bool is_enough() const { return is_enough_; }
  /// Whether more than one crossing is wanted.
  bool wants_all() const { return low_ == kBoundless; }
  /// Crossings up to this depth are not wanted, but may be added.
  double low() const { return low_; }
  /// Crossings behind this depth need not be added.
  double high() const { return high_; }

 private:
  const Shape* shape_;
  std::vector<Crossing>* out_;
  double low_;
  double high_ = kBoundless;
  bool is_enough_ = false;
};

/// The same ray with a direction of unit length; depths along it are `length` times as long. The direction is
/// multiplied by the reciprocal, as POV-Ray does: surfaces that coincide are then decided by the same rounding.
struct UnitRay {
  double length;
  Ray ray;

  explicit UnitRay(const Ray& given)
      : length(given.direction.length()), ray{given.origin, given.direction * (1.0 / length)} {}
};

/// Rays of a block, and a shape that they are to meet in a space of its own.
struct RaysAndPlace {
  const Shape& shape;
  const Transform& transform;       ///< from that space into the world
  const RayColumns& rays;           ///< in the world
  std::uint64_t who;                ///< bits of those that count
  const DepthWindow* nearest_only;  ///< as for Shape::meet_block
};

/// A primitive that is simple in a space of its own, under a transformation. `Local` brings the formulas:
///
///     void meet(const Ray& ray, Met& met) const;                     the ray's direction may have any length
///     bool inside(const Vec3& point, bool inverted) const;
///     void meet_block(const RaysAndPlace& asked, Slots& slots) const;  may be left out: ray by ray
///     std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
///                                std::uint64_t who) const;           may be left out: point by point
///     Vec3 normal(const Vec3& point, const Crossing& at) const;      outward, of any length
///     void normals(places, first, end, out) const;                   may be left out: one by one
///     Vec2 uv(const Vec3& point, const Crossing& at) const;          may be left out: x and y of the point in space
///     void textures(places, first, end, out) const;                  may be left out; as Shape's
///     Box3 bounds() const;
///     Box3 inside_bounds() const;
///     Box3 given_bounds() const;                                     may be left out: as bounds()
///     static constexpr bool kAsksBox;                                may be left out: true
///     static constexpr bool kIsLarge;                                may be left out: false
///     static constexpr bool kHasInside;                              may be left out: true; else inverting does nothing
///
/// Placing a shape composes the transformations and copies the Local; a large one is shared by all that are placed.
template <class Local>
class Placed final : public Shape {
 public:
  Placed(Local local, Transform transform, bool inverted = false)
      : Placed(Held(std::move(local)), std::move(transform), inverted) {}

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override {
    Met met(*this, out);
    local().meet(transform_.inverse_ray(ray), met);
  }
  void nearest(const Ray& ray, double low, double high, std::vector<Crossing>& out) const override {
    Met met(*this, out, low, high);
    local().meet(transform_.inverse_ray(ray), met);
  }
  bool inside(const Vec3& point) const override { return local().inside(transform_.inverse_point(point), inverted_); }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override {
    if constexpr (kIsOverLanes) {
      local().meet_block({*this, transform_, rays, who, nearest_only}, slots);
    } else {
      Shape::meet_block(rays, who, nearest_only, slots);
    }
  }
  std::uint64_t inside_block(const Columns3<double>& points, std::uint64_t who) const override {
    if constexpr (requires { &Local::inside_block; }) {
      return local().inside_block(transform_, inverted_, points, who);
    } else {
      return Shape::inside_block(points, who);
    }
  }
  bool is_over_lanes() const override { return kIsOverLanes; }
  Vec3 normal(const Vec3& point, const Crossing& crossing) const override {
    const Vec3 n = transform_.normal(local().normal(transform_.inverse_point(point), crossing)).normalized();
    return inverted_ ? -n : n;
  }
  void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const override {
    if constexpr (requires { &Local::normals; }) {
      local().normals(own_places(places, first, end), first, end, out);
    } else {
      Columns3<double> own;
      inverse_points(transform_, places.point, first, end, own);
      for (std::size_t i = first; i < end; ++i) out.set(i, local().normal(own.vector(i), *places.crossing[i]));
    }
    place_normals(transform_, inverted_, first, end, out);
  }
  Vec2 uv(const Vec3& point, const Crossing& crossing) const override {
    if constexpr (requires { local().uv(point, crossing); }) {
      return local().uv(transform_.inverse_point(point), crossing);
    } else {
      return Shape::uv(point, crossing);
    }
  }
  void uvs(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns2<double>& out) const override {
    for (std::size_t i = first; i < end; ++i) out.set(i, Placed::uv(places.point.vector(i), *places.crossing[i]));
  }
  void textures(const SurfacePlaces& places, std::size_t first, std::size_t end,
                std::vector<TextureShare>& out) const override {
    if constexpr (requires { local().textures(places, first, end, out); }) {
      local().textures(own_places(places, first, end), first, end, out);
    } else {
      Shape::textures(places, first, end, out);
    }
  }
  Box3 bounds() const override { return transform_.box(local().bounds()); }
  Box3 given_bounds() const override {
    if constexpr (requires { local().given_bounds(); }) return transform_.box(local().given_bounds());
    return bounds();
  }
  Box3 inside_bounds() const override { return inverted_ ? boundless_box() : transform_.box(local().inside_bounds()); }
  Box3 outside_bounds() const override { return inverted_ ? transform_.box(local().inside_bounds()) : boundless_box(); }
  ShapePtr placed(const Transform& transform) const override {
    return std::shared_ptr<const Placed>(new Placed(held_, transform_.then(transform), inverted_));
  }
  bool asks_box() const override {
    if constexpr (requires { Local::kAsksBox; }) return Local::kAsksBox;
    return true;
  }
  ShapePtr inverted() const override {
    if constexpr (requires { requires !Local::kHasInside; }) {
      return std::shared_ptr<const Placed>(new Placed(held_, transform_, inverted_));
    }
    return std::shared_ptr<const Placed>(new Placed(held_, transform_, !inverted_));
  }

 private:
  static constexpr bool kIsOverLanes = requires { &Local::meet_block; };

  static constexpr bool is_large() {
    if constexpr (requires { Local::kIsLarge; }) return Local::kIsLarge;
    return false;
  }
  /// A Local, or many shapes' share in one.
  struct Own {
    Local local;
    explicit Own(Local given) : local(std::move(given)) {}
    const Local& get() const { return local; }
  };
  struct Common {
    std::shared_ptr<const Local> local;
    explicit Common(Local given) : local(std::make_shared<const Local>(std::move(given))) {}
    const Local& get() const { return *local; }
  };
  using Held = std::conditional_t<is_large(), Common, Own>;

  Placed(Held held, Transform transform, bool inverted)
      : held_(std::move(held)), transform_(std::move(transform)), inverted_(inverted) {}
  const Local& local() const { return held_.get(); }
  SurfacePlaces own_places(const SurfacePlaces& places, std::size_t first, std::size_t end) const {
    SurfacePlaces own;
    inverse_points(transform_, places.point, first, end, own.point);
    for (std::size_t i = first; i < end; ++i) own.crossing[i] = places.crossing[i];
    return own;
  }

  Held held_;
  Transform transform_;
  bool inverted_;
};

}  // namespace firstlight::render
