#include "render/shape/lathe.h"

#include "render/math/polynomial.h"
#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;  ///< POV-Ray's for this shape
constexpr double kLevel = 1e-7;    ///< the sine of rays that run level, to within rounding
constexpr double kRoom = 1e-9;     ///< relative: the search goes this much beyond a segment's bounds

/// The turned curve in its own space.
struct Lathe {
  static constexpr bool kIsLarge = true;

  std::vector<ProfileSegment> segments;
  Vec2 low{kBoundless, kBoundless};
  Vec2 high{-kBoundless, -kBoundless};

  explicit Lathe(const LatheParameters& parameters) {
    const std::size_t points = parameters.points.size();
    const auto add = [&](std::size_t first) {
      const ProfileSegment& segment = segments.emplace_back(profile_segment(parameters.spline, parameters.points, first));
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], segment.low[axis]);
        high[axis] = std::max(high[axis], segment.high[axis]);
      }
    };
    if (parameters.spline == ProfileSpline::bezier) {
      for (std::size_t i = 0; i + 4 <= points; i += 4) add(i);
    } else {
      const std::size_t needed = static_cast<std::size_t>(parameters.spline) + 2;
      for (std::size_t i = 0; i + needed <= points; ++i) add(i);
    }
  }

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    // Depths are counted from the point nearest to the origin: there the coefficients keep their digits.
    const double skipped = -ray.origin.dot(ray.direction);
    const Ray here{ray.at(skipped), ray.direction};
    if (!reaches(here, low, high)) return;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (reaches(here, segments[i].low, segments[i].high)) meet(here, i, skipped, length, met);
    }
  }
  bool inside(const Vec3& p, bool inverted) const {
    std::size_t count = 0;
    const double radius = std::sqrt(p.x * p.x + p.z * p.z);
    if (p.y >= low.y && p.y <= high.y && radius <= high.x) {
      for (const ProfileSegment& segment : segments) count += crossings_beside(segment, radius, p.y);
    }
    return (count % 2 == 1) != inverted;
  }
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    const double squared = p.x * p.x + p.z * p.z;
    if (!(squared > kEpsilon)) return Vec3(0.0, 1.0, 0.0);
    const Vec2 slope = segments[at.face].slope(at.place[0]);
    return Vec3(slope.y * p.x, -slope.x * std::sqrt(squared), slope.y * p.z);
  }
  Vec2 uv(const Vec3& p, const Crossing& at) const {
    const double along = (at.place[0] + static_cast<double>(at.face)) / static_cast<double>(segments.size());
    return Vec2(turn_about_y(p.x, p.z), std::min(along, 1.0));
  }
  Box3 bounds() const { return Box3(Vec3(-high.x, low.y, -high.x), Vec3(high.x, high.y, high.x)); }
  Box3 inside_bounds() const { return bounds(); }

 private:
  /// Whether a ray comes between the heights and distances from the axis of a rectangle that is turned.
  static bool reaches(const Ray& ray, const Vec2& low, const Vec2& high) {
    const Vec3& p = ray.origin;
    const Vec3& d = ray.direction;
    const double room = kRoom * (1.0 + std::max(std::abs(low.y), std::abs(high.y)) + high.x);
    double from = -kBoundingHuge;
    double to = kBoundingHuge;
    if (std::abs(d.y) > kEpsilon) {
      from = ((d.y > 0.0 ? low.y : high.y) - p.y) / d.y - room / std::abs(d.y);
      to = ((d.y > 0.0 ? high.y : low.y) - p.y) / d.y + room / std::abs(d.y);
    } else if (p.y < low.y - room || p.y > high.y + room) {
      return false;
    }
    const double across = d.x * d.x + d.z * d.z;
    const double nearest = across > 0.0 ? -(p.x * d.x + p.z * d.z) / across : 0.0;
    const auto squared = [&](double t) {
      const double x = p.x + t * d.x;
      const double z = p.z + t * d.z;
      return x * x + z * z;
    };
    const double outer = high.x + room;
    const double inner = std::max(0.0, low.x - room);
    return squared(std::clamp(nearest, from, to)) <= outer * outer &&
           std::max(squared(from), squared(to)) >= inner * inner;
  }

  void meet(const Ray& ray, std::size_t index, double skipped, double length, Met& met) const {
    const Vec3& p = ray.origin;
    const Vec3& d = ray.direction;
    const ProfileSegment& s = segments[index];
    const auto add = [&](double t, double w) {
      const double depth = (t + skipped) / length;
      if (depth > kNearest && depth < kMaxDistance) met.add(depth, static_cast<std::uint32_t>(index), {w, 0.0});
    };
    // On the ray y = p.y + t d.y, and the square of the distance from the axis is r t^2 + 2 m t + q. With t from the
    // curve's height it must be the curve's: r (y - p.y)^2 + 2 m d.y (y - p.y) + d.y^2 (q - x^2) = 0.
    const double r = d.x * d.x + d.z * d.z;
    const double m = d.x * p.x + d.z * p.z;
    const double q = p.x * p.x + p.z * p.z;
    const double dy2 = d.y * d.y;
    const std::array<double, 4> x = {s.d.x, s.c.x, s.b.x, s.a.x};
    const std::array<double, 4> y = {s.d.y - p.y, s.c.y, s.b.y, s.a.y};
    // A level ray stays at its height: what is left of the equation is the square of the curve's height above it.
    const bool is_level = std::abs(d.y) < kLevel;
    std::array<double, 7> equation{};
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_level) {
        equation[i] = y[i];
        continue;
      }
      for (std::size_t k = 0; k < 4; ++k) equation[i + k] += r * y[i] * y[k] - dy2 * x[i] * x[k];
      equation[i] += 2.0 * m * d.y * y[i];
    }
    if (!is_level) equation[0] += dy2 * q;
    std::size_t order = 6;
    while (order > 0 && equation[order] == 0.0) --order;
    PolynomialRoots roots({equation.data(), order + 1}, 0.0, 1.0);
    for (double w; roots.next(w);) {
      if (!is_level) {
        add((s.at(w).y - p.y) / d.y, w);
        continue;
      }
      const double radius = s.at(w).x;
      const double discriminant = m * m - r * (q - radius * radius);
      if (!(discriminant >= 0.0) || r == 0.0) continue;
      const double root = std::sqrt(discriminant);
      add((-m + root) / r, w);
      add((-m - root) / r, w);
    }
  }
};

}  // namespace

ShapePtr make_lathe(const LatheParameters& parameters) {
  return std::make_shared<Placed<Lathe>>(Lathe(parameters), Transform());
}

}  // namespace firstlight::render
