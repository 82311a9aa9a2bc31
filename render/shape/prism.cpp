#include "render/shape/prism.h"

#include "render/math/polynomial.h"
#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;  ///< POV-Ray's for this shape
constexpr double kRoom = 1e-9;     ///< relative: the search goes this much beyond a segment's rectangle
constexpr double kFar = 1e100;     ///< half the size of a rectangle without end

constexpr std::uint32_t kBase = 0xfffffffeu;
constexpr std::uint32_t kCap = 0xffffffffu;

bool is_same(const Vec2& a, const Vec2& b) { return std::abs(a.x - b.x) < kEpsilon && std::abs(a.y - b.y) < kEpsilon; }

/// The segments of all curves; from a point that closes one to the first of the next there is none. [POV-Ray 3.7]
std::vector<ProfileSegment> segments_of(const PrismParameters& parameters) {
  const std::vector<Vec2>& points = parameters.points;
  const ProfileSpline spline = parameters.spline;
  std::vector<ProfileSegment> segments;
  if (spline == ProfileSpline::bezier) {
    const std::vector<Vec2> backwards(points.rbegin(), points.rend());  // as POV-Ray has them: it turns their normals
    for (std::size_t i = points.size(); i >= 4; i -= 4) {
      segments.push_back(profile_segment(spline, backwards, points.size() - i));
    }
    return segments;
  }
  const auto kind = static_cast<std::size_t>(spline);  // 0, 1, 2: how many points give directions
  const std::size_t ahead = kind == 0 ? 1 : 2;         // from the first point of a segment to where it ends
  std::size_t begin = kind == 0 ? 0 : 1;
  for (std::size_t i = 0; i + kind + 2 <= points.size(); ++i) {
    segments.push_back(profile_segment(spline, points, i));
    if (!is_same(points[i + ahead], points[std::min(begin, points.size() - 1)])) continue;
    i += kind + 1;
    begin = i + ahead;
  }
  return segments;
}

/// A rectangle in the plane of the curves.
struct Rectangle {
  Vec2 middle{0.0};
  Vec2 half{kFar};

  Rectangle() = default;
  Rectangle(const Vec2& low, const Vec2& high, double room)
      : middle((low + high) * 0.5), half((high - low) * 0.5 + Vec2(room)) {}

  bool meets(const Rectangle& other) const {
    return std::abs(middle.x - other.middle.x) <= half.x + other.half.x &&
           std::abs(middle.y - other.middle.y) <= half.y + other.half.y;
  }
  /// Whether its corners lie on both sides of the line u x + v y + w = 0.
  bool meets_line(const Vec3& line) const {
    return std::abs(line.x * middle.x + line.y * middle.y + line.z) <=
           std::abs(line.x) * half.x + std::abs(line.y) * half.y;
  }
};

/// The swept curves in their own space. In the plane of the curves y stands for z.
struct Prism {
  static constexpr bool kIsLarge = true;
  using Sweep = PrismParameters::Sweep;

  std::vector<ProfileSegment> segments;
  std::vector<Rectangle> rectangles;  ///< about the segments, with room for rounding
  Vec2 low{kBoundless, kBoundless};   ///< a rectangle about the curves
  Vec2 high{-kBoundless, -kBoundless};
  double bottom;
  double top;
  Sweep sweep;
  bool open;

  double nearest = kNearest;
  bool turns_base = false;  ///< the base's normal points down

  explicit Prism(const PrismParameters& parameters) : Prism(segments_of(parameters), parameters) {}
  /// Takes from `parameters` only what is beside the curves.
  Prism(std::vector<ProfileSegment> curves, const PrismParameters& parameters)
      : segments(std::move(curves)),
        bottom(parameters.low),
        top(parameters.high),
        sweep(parameters.sweep),
        open(parameters.open) {
    for (const ProfileSegment& segment : segments) {
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], segment.low[axis]);
        high[axis] = std::max(high[axis], segment.high[axis]);
      }
      rectangles.emplace_back(segment.low, segment.high, kRoom * (1.0 + size(segment.low) + size(segment.high)));
    }
  }

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    const Vec3& p = ray.origin;
    const Vec3& d = ray.direction;
    const auto add = [&met, l = length, this](double t, std::uint32_t face, double w) {
      const double depth = t / l;
      if (depth > nearest && depth < kMaxDistance) met.add(depth, face, {w, 0.0});
    };
    if (std::abs(d.y) < kEpsilon) {
      if (p.y < bottom || p.y > top) return;
    } else if (!open) {
      const auto meet_cap = [&](double height, std::uint32_t face) {
        const double size = sweep == Sweep::conic ? height : 1.0;
        if (!(std::abs(size) > kEpsilon)) return;
        const double t = (height - p.y) / d.y;
        if (t > nearest && t < kMaxDistance && is_in_curves((p.x + t * d.x) / size, (p.z + t * d.z) / size)) {
          add(t, face, 0.0);
        }
      };
      meet_cap(top, kCap);
      meet_cap(bottom, kBase);
    }
    if (!(std::abs(d.x) > kEpsilon || std::abs(d.z) > kEpsilon)) return;
    // A line in the plane of the curves: u x + v y + w = 0. Of a cone it is where the plane through the ray and the tip
    // cuts height 1.
    Vec3 line(d.z, -d.x, d.x * p.z - d.z * p.x);
    if (sweep == Sweep::conic) line = Vec3(p.z * d.y - p.y * d.z, p.y * d.x - p.x * d.y, p.x * d.z - p.z * d.x);
    const Rectangle shadow = shadow_of(p, d);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (!rectangles[i].meets(shadow) || !rectangles[i].meets_line(line)) continue;
      const ProfileSegment& s = segments[i];
      const auto along = [&](const Vec2& v) { return line.x * v.x + line.y * v.y; };
      const std::array<double, 4> beside = {along(s.d) + line.z, along(s.c), along(s.b), along(s.a)};
      PolynomialRoots roots(beside, 0.0, 1.0);
      for (double w; roots.next(w);) {
        double t;
        if (!depth_at(s.at(w), p, d, t)) continue;
        const double height = p.y + t * d.y;
        if (height >= bottom && height <= top) add(t, static_cast<std::uint32_t>(i), w);
      }
    }
  }
  bool inside(const Vec3& p, bool inverted) const {
    if (!(p.y >= bottom && p.y < top)) return inverted;
    const double size = sweep == Sweep::conic ? p.y : 1.0;
    if (!(std::abs(size) > kEpsilon)) return inverted;
    return is_in_curves(p.x / size, p.z / size) != inverted;
  }
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kBase && turns_base) return Vec3(0.0, -1.0, 0.0);
    if (at.face == kBase || at.face == kCap) return Vec3(0.0, 1.0, 0.0);
    const Vec2 slope = segments[at.face].slope(at.place[0]);
    Vec3 n(slope.y, 0.0, -slope.x);
    if (sweep == Sweep::conic) {
      if (!(std::abs(p.y) > kEpsilon)) return Vec3(0.0, 1.0, 0.0);
      n.y = -(p.x * n.x + p.z * n.z) / p.y;
    }
    return n;
  }
  Box3 bounds() const {
    Box3 box;
    for (const double height : {bottom, top}) {
      const double size = sweep == Sweep::conic ? height : 1.0;
      box.extendBy(Vec3(low.x * size, height, low.y * size));
      box.extendBy(Vec3(high.x * size, height, high.y * size));
    }
    return box;
  }
  Box3 inside_bounds() const { return bounds(); }

 private:
  bool is_in_curves(double u, double v) const {
    if (!(u >= low.x && u <= high.x && v >= low.y && v <= high.y)) return false;
    std::size_t count = 0;
    for (const ProfileSegment& segment : segments) count += crossings_beside(segment, u, v);
    return count % 2 == 1;
  }
  static double size(const Vec2& v) { return std::abs(v.x) + std::abs(v.y); }
  /// About what of the ray lies between the heights of the prism, in the plane of the curves.
  Rectangle shadow_of(const Vec3& p, const Vec3& d) const {
    if (!(std::abs(d.y) > kEpsilon) || (sweep == Sweep::conic && !(bottom * top > 0.0))) return {};
    const double t1 = (bottom - p.y) / d.y;
    const double t2 = (top - p.y) / d.y;
    Vec2 a(p.x + t1 * d.x, p.z + t1 * d.z);
    Vec2 b(p.x + t2 * d.x, p.z + t2 * d.z);
    double room = size(Vec2(p.x, p.z)) + size(a) + size(b);
    if (sweep == Sweep::conic) {
      a /= bottom;
      b /= top;
      room /= std::min(std::abs(bottom), std::abs(top));
    }
    return Rectangle(Vec2(std::min(a.x, b.x), std::min(a.y, b.y)), Vec2(std::max(a.x, b.x), std::max(a.y, b.y)),
                     kRoom * (1.0 + room));
  }
  /// The depth at which the ray meets the place of a curve. False: it runs along it.
  bool depth_at(const Vec2& place, const Vec3& p, const Vec3& d, double& t) const {
    if (sweep == Sweep::linear) {
      t = std::abs(d.x) > kEpsilon ? (place.x - p.x) / d.x : (place.y - p.z) / d.z;
      return true;
    }
    const double approach = d.x - place.x * d.y;
    if (std::abs(approach) > kEpsilon) {
      t = (place.x * p.y - p.x) / approach;
      return true;
    }
    const double other = d.z - place.y * d.y;
    if (!(std::abs(other) > kEpsilon)) return false;
    t = (place.y * p.y - p.z) / other;
    return true;
  }
};

}  // namespace

ShapePtr make_prism(const PrismParameters& parameters) {
  return std::make_shared<Placed<Prism>>(Prism(parameters), Transform());
}

ShapePtr make_letter(std::vector<ProfileSegment> outline, double thickness) {
  constexpr double kNearestOfText = 1e-6;  // POV-Ray's
  Prism letter(std::move(outline),
               {ProfileSpline::quadratic, PrismParameters::Sweep::linear, 0.0, thickness, {}, false});
  letter.nearest = kNearestOfText;
  letter.turns_base = true;
  const Mat4 upright(1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1);  // y and z change places
  return std::make_shared<Placed<Prism>>(std::move(letter), Transform(upright));
}

}  // namespace firstlight::render
