#pragma once

#include "render/shape/shape.h"

#include <array>
#include <cstddef>
#include <utility>

namespace firstlight::render {

/// The crossings of one primitive with one ray: depths along the ray as it was given.
struct Met {
  std::array<double, 4> depth;
  std::array<std::uint32_t, 4> face;
  std::size_t count = 0;

  void add(double at, std::uint32_t which = 0) {
    depth[count] = at;
    face[count++] = which;
  }
};

/// The same ray with a direction of unit length; depths along it are `length` times as long. The direction is
/// multiplied by the reciprocal, as POV-Ray does: surfaces that coincide are then decided by the same rounding.
struct UnitRay {
  double length;
  Ray ray;

  explicit UnitRay(const Ray& given)
      : length(given.direction.length()), ray{given.origin, given.direction * (1.0 / length)} {}
};

/// A primitive that is simple in a space of its own, under a transformation. `Local` brings the formulas:
///
///     void meet(const Ray& ray, Met& met) const;                     the ray's direction may have any length
///     bool inside(const Vec3& point, bool inverted) const;
///     Vec3 normal(const Vec3& point, std::uint32_t face) const;      outward, of any length
///     Box3 bounds() const;
///     Box3 inside_bounds() const;
///     Box3 given_bounds() const;                                     may be left out: as bounds()
///     static constexpr bool kAsksBox;                                may be left out: true
///
/// A Local is a small value; placing a shape copies it and composes the transformations.
template <class Local>
class Placed final : public Shape {
 public:
  Placed(Local local, Transform transform, bool inverted = false)
      : local_(std::move(local)), transform_(std::move(transform)), inverted_(inverted) {}

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override {
    Met met;
    local_.meet(transform_.inverse_ray(ray), met);
    for (std::size_t i = 0; i < met.count; ++i) out.push_back({met.depth[i], this, 0, met.face[i]});
  }
  bool inside(const Vec3& point) const override { return local_.inside(transform_.inverse_point(point), inverted_); }
  Vec3 normal(const Vec3& point, const Crossing& crossing) const override {
    const Vec3 n = transform_.normal(local_.normal(transform_.inverse_point(point), crossing.face)).normalized();
    return inverted_ ? -n : n;
  }
  Box3 bounds() const override { return transform_.box(local_.bounds()); }
  Box3 given_bounds() const override {
    if constexpr (requires { local_.given_bounds(); }) return transform_.box(local_.given_bounds());
    return bounds();
  }
  Box3 inside_bounds() const override { return inverted_ ? boundless_box() : transform_.box(local_.inside_bounds()); }
  Box3 outside_bounds() const override { return inverted_ ? transform_.box(local_.inside_bounds()) : boundless_box(); }
  ShapePtr placed(const Transform& transform) const override {
    return std::make_shared<Placed>(local_, transform_.then(transform), inverted_);
  }
  bool asks_box() const override {
    if constexpr (requires { Local::kAsksBox; }) return Local::kAsksBox;
    return true;
  }
  ShapePtr inverted() const override { return std::make_shared<Placed>(local_, transform_, !inverted_); }

 private:
  Local local_;
  Transform transform_;
  bool inverted_;
};

}  // namespace firstlight::render
