#include "render/shape/ovus.h"

#include "render/math/polynomial.h"
#include "render/shape/placed.h"
#include "render/shape/sphere.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

/// POV-Ray's for this shape: how far from the tube a root may be, as a difference of squares.
constexpr double kRootRoom = 1e-4;

enum Face : std::uint32_t { kBottom, kTop, kSide };

struct Ovus {
  double bottom;          ///< radii
  double top;
  double tube;            ///< of the torus that joins the balls
  double ring;            ///< of its circle, on whose far side of the axis the surface lies
  double ring_height;
  double bottom_ends;     ///< the height where the lower ball ends
  double top_begins;

  Ovus(double bottom_radius, double top_radius) : bottom(bottom_radius), top(top_radius) {
    if (bottom > top) {
      tube = 2.0 * bottom;
      ring_height = 2.0 * top - bottom - top * top / (2.0 * bottom);
      ring = std::sqrt(std::max(0.0, bottom * bottom - ring_height * ring_height));
      bottom_ends = -ring_height;
      top_begins = (bottom - ring_height) * top / (tube - top) + bottom;
    } else {
      tube = 2.0 * top;
      ring_height = -2.0 * top + bottom + 1.5 * top * top / bottom;
      ring = std::sqrt(std::max(0.0, top * top - (ring_height - bottom) * (ring_height - bottom)));
      top_begins = 2.0 * bottom - ring_height;
      bottom_ends = -ring_height * bottom / (tube - bottom);
    }
  }

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    const auto add = [&met, l = length](double depth, Face face) {
      if (depth > kEpsilon) met.add(depth / l, face);
    };
    const auto height = [&, &r = ray](double depth) { return r.origin.y + depth * r.direction.y; };
    double enters;
    double leaves;
    if (meet_sphere(ray, Vec3(0.0), bottom * bottom, enters, leaves)) {
      for (const double depth : {enters, leaves}) {
        if (height(depth) < bottom_ends) add(depth, kBottom);
      }
    }
    if (meet_sphere(ray, Vec3(0.0, bottom, 0.0), top * top, enters, leaves)) {
      for (const double depth : {enters, leaves}) {
        if (height(depth) > top_begins) add(depth, kTop);
      }
    }
    meet_side(ray, add);
  }
  bool inside(const Vec3& p, bool inverted) const {
    bool is_in = p.length2() < bottom * bottom || (p - Vec3(0.0, bottom, 0.0)).length2() < top * top;
    if (p.y > bottom_ends && p.y < top_begins) is_in = is_in || from_ring_squared(p) < tube * tube;
    return is_in != inverted;
  }
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kBottom) return p;
    if (at.face == kTop) return p - Vec3(0.0, bottom, 0.0);
    const double from_axis = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(from_axis > 0.0)) return Vec3(0.0, p.y - ring_height, 0.0);
    const double out = 1.0 + ring / from_axis;
    return Vec3(p.x * out, p.y - ring_height, p.z * out);
  }
  Vec2 uv(const Vec3& p, const Crossing&) const { return sphere_uv(p - Vec3(0.0, 0.5 * top, 0.0)); }
  Box3 bounds() const {
    const double widest = std::max({tube - ring, bottom, top});
    return Box3(Vec3(-widest, -bottom, -widest), Vec3(widest, bottom + top, widest));
  }
  Box3 inside_bounds() const { return bounds(); }

 private:
  double from_ring_squared(const Vec3& p) const {
    const double across = std::sqrt(p.x * p.x + p.z * p.z) + ring;
    const double up = p.y - ring_height;
    return across * across + up * up;
  }
  /// The torus' inner sheet, between the balls.
  template <class Add>
  void meet_side(const Ray& ray, const Add& add) const {
    const Vec3& d = ray.direction;
    // Depths are counted from the point nearest to the ring's middle: there the coefficients keep their digits.
    const Vec3 from_middle = ray.origin - Vec3(0.0, ring_height, 0.0);
    const double skipped = -from_middle.dot(d);
    const Vec3 p = from_middle + d * skipped;
    const double reach = ring + tube;
    const double half_squared = reach * reach - p.length2();
    if (!(half_squared > 0.0)) return;
    const double half = std::sqrt(half_squared);
    const double ring2 = ring * ring;
    const double k1 = p.length2() - ring2 - tube * tube;
    const double k2 = p.dot(d);
    const std::array<double, 5> quartic = {k1 * k1 + 4.0 * ring2 * (p.y * p.y - tube * tube),
                                           4.0 * (k1 * k2 + 2.0 * ring2 * p.y * d.y),
                                           2.0 * k1 + 4.0 * k2 * k2 + 4.0 * ring2 * d.y * d.y, 4.0 * k2, 1.0};
    PolynomialRoots roots(quartic, -half, half);
    for (double t; roots.next(t);) {
      const double depth = t + skipped;
      const Vec3 point = ray.at(depth);
      if (!(point.y > bottom_ends && point.y < top_begins)) continue;
      if (std::abs(from_ring_squared(point) - tube * tube) < kRootRoom) add(depth, kSide);
    }
  }
};

}  // namespace

ShapePtr make_ovus(double bottom_radius, double top_radius) {
  return std::make_shared<Placed<Ovus>>(Ovus(bottom_radius, top_radius), Transform());
}

}  // namespace firstlight::render
