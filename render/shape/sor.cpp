#include "render/shape/sor.h"

#include "render/math/polynomial.h"
#include "render/shape/placed.h"
#include "render/shape/profile.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;  ///< POV-Ray's for this shape; a cap of a smaller squared radius is left out
constexpr double kRoom = 1e-9;     ///< relative: the search goes this much beyond a segment's height

constexpr std::uint32_t kBase = 0xfffffffeu;
constexpr std::uint32_t kCap = 0xffffffffu;

/// The square of the radius at height y is ((a y + b) y + c) y + d.
struct Segment {
  double low;
  double high;
  double a, b, c, d;

  double squared_radius(double y) const { return ((a * y + b) * y + c) * y + d; }
  double slope(double y) const { return (3.0 * a * y + 2.0 * b) * y + c; }
};

/// Between p[1] and p[2], with the slopes that p[0] and p[3] give. [POV-Ray 3.7]
Segment segment_of(const Vec2* p) {
  const double value0 = p[1].x * p[1].x;
  const double value1 = p[2].x * p[2].x;
  const double slope0 = 2.0 * p[1].x * (p[2].x - p[0].x) / (p[2].y - p[0].y);
  const double slope1 = 2.0 * p[2].x * (p[3].x - p[1].x) / (p[3].y - p[1].y);
  const double start = p[1].y;
  const double height = p[2].y - start;
  // In t = y - start: value0 + slope0 t + square t^2 + cube t^3.
  const double rise = (value1 - value0) / height;
  const double square = (3.0 * rise - 2.0 * slope0 - slope1) / height;
  const double cube = (slope0 + slope1 - 2.0 * rise) / (height * height);
  Segment segment{start, p[2].y, cube, square - 3.0 * cube * start,
                  slope0 - 2.0 * square * start + 3.0 * cube * start * start,
                  value0 - slope0 * start + square * start * start - cube * start * start * start};
  for (double* number : {&segment.a, &segment.b, &segment.c, &segment.d}) {
    if (std::abs(*number) < kEpsilon) *number = 0.0;
  }
  return segment;
}

/// The turned curve in its own space.
struct Sor {
  static constexpr bool kIsLarge = true;

  std::vector<Segment> segments;
  double radius = 0.0;
  double base_squared = 0.0;  ///< radii of the caps
  double cap_squared = 0.0;
  bool open = false;

  explicit Sor(const SorParameters& parameters) : open(parameters.open) {
    const std::vector<Vec2>& points = parameters.points;
    for (std::size_t i = 0; i + 4 <= points.size(); ++i) {
      const Segment& segment = segments.emplace_back(segment_of(points.data() + i));
      radius = std::max({radius, points[i + 1].x, points[i + 2].x});
      include_turns(segment);
    }
    base_squared = std::max(0.0, segments.front().squared_radius(low()));
    cap_squared = std::max(0.0, segments.back().squared_radius(high()));
  }

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    // Depths are counted from the point nearest to the origin: there the coefficients keep their digits.
    const double skipped = -ray.origin.dot(ray.direction);
    const Vec3 p = ray.at(skipped);
    const Vec3& d = ray.direction;
    const auto add = [&, l = length](double t, std::uint32_t face) {
      const double depth = (t + skipped) / l;
      if (depth > kNearest && depth < kMaxDistance) met.add(depth, face);
    };
    if (!open && std::abs(d.y) > kEpsilon) {
      const auto meet_cap = [&](double height, double squared, std::uint32_t face) {
        if (!(squared > kNearest)) return;
        const double t = (height - p.y) / d.y;
        const double x = p.x + t * d.x;
        const double z = p.z + t * d.z;
        if (x * x + z * z <= squared) add(t, face);
      };
      meet_cap(low(), base_squared, kBase);
      meet_cap(high(), cap_squared, kCap);
    }
    const double r = d.x * d.x + d.z * d.z;
    const double m = p.x * d.x + p.z * d.z;
    const double q = p.x * p.x + p.z * p.z;
    double from = -kBoundingHuge;
    double to = kBoundingHuge;
    if (r > kEpsilon) {
      const double reach = radius * (1.0 + kRoom) + kRoom;
      const double discriminant = m * m - r * (q - reach * reach);
      if (!(discriminant >= 0.0)) return;
      from = (-m - std::sqrt(discriminant)) / r;
      to = (-m + std::sqrt(discriminant)) / r;
    }
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Segment& s = segments[i];
      double begin = from;
      double end = to;
      if (std::abs(d.y) > kEpsilon) {
        const double room = kRoom * (1.0 + std::abs(s.low) + std::abs(s.high)) / std::abs(d.y);
        begin = std::max(begin, ((d.y > 0.0 ? s.low : s.high) - p.y) / d.y - room);
        end = std::min(end, ((d.y > 0.0 ? s.high : s.low) - p.y) / d.y + room);
      } else if (p.y < s.low || p.y > s.high) {
        continue;
      }
      const std::array<double, 4> equation = {
          p.y * (p.y * (s.a * p.y + s.b) + s.c) + s.d - q,
          d.y * (p.y * (3.0 * s.a * p.y + 2.0 * s.b) + s.c) - 2.0 * m,
          d.y * d.y * (3.0 * s.a * p.y + s.b) - r,
          s.a * d.y * d.y * d.y,
      };
      PolynomialRoots roots(equation, begin, end);
      for (double t; roots.next(t);) {
        const double height = p.y + t * d.y;
        if (height >= s.low && height <= s.high) add(t, static_cast<std::uint32_t>(i));
      }
    }
  }
  bool inside(const Vec3& p, bool inverted) const {
    const double squared = p.x * p.x + p.z * p.z;
    if (squared <= radius * radius) {
      for (const Segment& segment : segments) {
        if (p.y < segment.low || p.y > segment.high) continue;
        return (squared <= segment.squared_radius(p.y)) != inverted;
      }
    }
    return inverted;
  }
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kBase) return Vec3(0.0, -1.0, 0.0);
    if (at.face == kCap) return Vec3(0.0, 1.0, 0.0);
    return Vec3(p.x, -0.5 * segments[at.face].slope(p.y), p.z);
  }
  Vec2 uv(const Vec3& p, const Crossing& at) const {
    const double u = turn_about_y(p.x, p.z);
    const double from_axis = std::sqrt(p.x * p.x + p.z * p.z);
    if (at.face == kBase) return Vec2(u, from_axis / std::sqrt(base_squared) - 1.0);
    if (at.face == kCap) return Vec2(u, 2.0 - from_axis / std::sqrt(cap_squared));
    const Segment& segment = segments[at.face];
    const double share = 1.0 / static_cast<double>(segments.size());
    return Vec2(u, (p.y - segment.low) / (segment.high - segment.low) * share + static_cast<double>(at.face) * share);
  }
  Box3 bounds() const { return Box3(Vec3(-radius, low(), -radius), Vec3(radius, high(), radius)); }
  Box3 inside_bounds() const { return bounds(); }

 private:
  double low() const { return segments.front().low; }
  double high() const { return segments.back().high; }
  /// Where the curve is farthest from the axis between its points.
  void include_turns(const Segment& s) {
    const double b = s.b;
    const double a = 3.0 * s.a;
    std::array<double, 2> turns{s.low, s.low};
    if (std::abs(a) < kEpsilon) {
      if (b != 0.0) turns[0] = -0.5 * s.c / b;
    } else if (b * b - a * s.c >= 0.0) {
      const double root = std::sqrt(b * b - a * s.c);
      turns = {(-b + root) / a, (-b - root) / a};
    }
    for (const double y : turns) {
      if (y >= s.low && y <= s.high) radius = std::max(radius, std::sqrt(std::max(0.0, s.squared_radius(y))));
    }
  }
};

}  // namespace

ShapePtr make_sor(const SorParameters& parameters) {
  return std::make_shared<Placed<Sor>>(Sor(parameters), Transform());
}

}  // namespace firstlight::render
