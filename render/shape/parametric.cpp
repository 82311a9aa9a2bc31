#include "render/shape/parametric.h"

#include "render/math/interrupt.h"
#include "render/shape/placed.h"
#include "render/shape/ray_field.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace firstlight::render {
namespace {

/// Rectangles whose bounds are kept in any case: those of so many levels, the whole being the first.
constexpr int kKeptLevels = 11;
constexpr std::size_t kDeepestSplit = 120;
/// Of one ray, which then meets nothing. A gradient that is far too large leaves no rectangle out.
constexpr int kMostRectangles = 300'000;
constexpr double kStartRoom = 4.0;  ///< times the accuracy, behind the container's beginning. [POV-Ray 3.7]

struct Range {
  double low;
  double high;
};

/// Of u and v. Halves of a rectangle of number n have the numbers 2 n and 2 n + 1; the whole's is 1, and numbers beyond
/// kMostNumber are not told apart.
struct Rectangle {
  static constexpr std::uint32_t kMostNumber = 10'000'000;

  Vec2 low;
  Vec2 high;
  std::uint32_t number = 1;

  double longer_side() const { return std::max(high.x - low.x, high.y - low.y); }
  /// The lower and the upper half along the longer side.
  std::array<Rectangle, 2> halves() const {
    const int axis = high.y - low.y > high.x - low.x ? 1 : 0;
    std::array<Rectangle, 2> both = {*this, *this};
    both[0].high[axis] = both[1].low[axis] = (high[axis] + low[axis]) / 2.0;
    both[0].number = std::min(2 * number, kMostNumber);
    both[1].number = both[0].number + 1;
    return both;
  }
};

/// What a function may reach over a side or a rectangle, of what it is at the ends.
Range reach(double length, double at_low, double at_high, double gradient) {
  const double room = std::max(0.0, gradient * (length - std::abs(at_low - at_high) / gradient) / 2.0);
  return {std::min(at_low, at_high) - room, std::max(at_low, at_high) + room};
}

/// The depths at which a ray is between two planes across an axis.
struct Slab {
  double begin = 0.0;
  double end = 0.0;
  bool is_along = false;  ///< the ray keeps between them
};

struct Parametric {
  static constexpr bool kIsLarge = true;
  static constexpr bool kHasInside = false;

  ParametricParameters p;
  std::array<std::vector<Range>, 3> kept;  ///< bounds of a coordinate by a rectangle's number

  explicit Parametric(const ParametricParameters& parameters) : p(parameters) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (p.precompute[axis] && p.precompute_depth > 0) {
        kept[axis].resize(std::size_t{1} << p.precompute_depth);
        precompute(axis, {p.low, p.high});
      } else {
        kept[axis].resize(std::size_t{1} << kKeptLevels);
        keep(axis, {p.low, p.high});
      }
    }
  }

  /// Source  POV-Ray 3.7: rectangles of u and v are halved as long as the ray may meet what they may reach; what is small
  ///         enough is met at the nearest depth of its reach along z, or the last axis that the ray does not run across.
  void meet(const Ray& ray, Met& met) const {
    const std::optional<ContainedPart> part = contained_part(p.container, ray);
    if (!part) return;
    double begin = part->begin == part->end ? 0.0 : part->begin;
    begin += kStartRoom * p.accuracy;
    if (begin > part->end) return;
    thread_local std::vector<Rectangle> waiting;
    waiting.assign(1, {p.low, p.high});
    double nearest = kBoundless;
    Vec2 uv(0.0);
    Evaluation evaluation{.noise_generator = p.noise_generator};
    for (int count = 0; !waiting.empty(); ++count) {
      if (count > kMostRectangles || (count % 64 == 0 && Interrupt::asked())) return;
      const Rectangle here = waiting.back();
      waiting.pop_back();
      double depth = 0.0;
      double longest = 0.0;
      if (!may_meet(ray, here, {begin, part->end}, nearest, evaluation, depth, longest)) continue;
      if (std::min(here.longer_side(), longest) < p.accuracy) {
        if (depth < nearest && depth > begin) {
          nearest = depth;
          uv = here.low;
        }
      } else if (waiting.size() < kDeepestSplit) {
        const std::array<Rectangle, 2> halves = here.halves();
        waiting.push_back(halves[1]);
        waiting.push_back(halves[0]);
      }
    }
    if (nearest < part->end && nearest > 0.0) met.add(nearest, 0, {uv.x, uv.y});
  }
  bool inside(const Vec3&, bool) const { return false; }
  Vec3 normal(const Vec3&, const Crossing& at) const {
    std::array<FieldColumn, 3> points;
    for (FieldColumn& column : points) std::fill_n(column.begin(), 3, 0.0);
    points[0] = {at.place[0], at.place[0] + p.accuracy, at.place[0]};
    points[1] = {at.place[1], at.place[1], at.place[1] + p.accuracy};
    Vec3 along_u;
    Vec3 along_v;
    Evaluation evaluation{.noise_generator = p.noise_generator};
    for (int axis = 0; axis < 3; ++axis) {
      FieldColumn values;
      evaluate_field(*p.functions[static_cast<std::size_t>(axis)], points, 3, values, evaluation);
      along_u[axis] = values[1] - values[0];
      along_v[axis] = values[2] - values[0];
    }
    const Vec3 n = along_u.cross(along_v);
    const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    return largest > 0.0 && std::isfinite(largest) ? n / largest : Vec3(1.0, 0.0, 0.0);
  }
  Vec2 uv(const Vec3&, const Crossing& at) const { return Vec2(at.place[0], at.place[1]); }
  Box3 bounds() const { return bounds_of(p.container); }
  Box3 inside_bounds() const { return bounds(); }

 private:
  /// What a coordinate may reach in a rectangle, of what it is in the corners. POV-Ray takes the accuracy off.
  Range range_in(std::size_t axis, const Rectangle& r, Evaluation& evaluation) const {
    std::array<FieldColumn, 3> corners;
    corners[0] = {r.low.x, r.low.x, r.high.x, r.high.x};
    corners[1] = {r.low.y, r.high.y, r.low.y, r.high.y};
    std::fill_n(corners[2].begin(), 4, 0.0);
    FieldColumn f;
    evaluate_field(*p.functions[axis], corners, 4, f, evaluation);
    for (std::size_t i = 0; i < 4; ++i) f[i] -= p.accuracy;
    const Range first = reach(r.high.y - r.low.y, f[0], f[1], p.max_gradient);
    const Range last = reach(r.high.y - r.low.y, f[2], f[3], p.max_gradient);
    const double width = r.high.x - r.low.x;
    return {reach(width, first.low, last.low, p.max_gradient).low, reach(width, first.high, last.high, p.max_gradient).high};
  }
  Range range(std::size_t axis, const Rectangle& r, Evaluation& evaluation) const {
    return r.number < kept[axis].size() ? kept[axis][r.number] : range_in(axis, r, evaluation);
  }

  /// The bounds that meet() would find.
  void keep(std::size_t axis, const Rectangle& whole) {
    std::vector<Rectangle> waiting{whole};
    Evaluation evaluation{.noise_generator = p.noise_generator};
    while (!waiting.empty()) {
      const Rectangle here = waiting.back();
      waiting.pop_back();
      kept[axis][here.number] = range_in(axis, here, evaluation);
      if (2 * here.number >= kept[axis].size()) continue;
      for (const Rectangle& half : here.halves()) waiting.push_back(half);
    }
  }
  /// Bounds of the smallest rectangles; those of the others enclose their halves'. Recursion: kDeepestPrecompute.
  Range precompute(std::size_t axis, const Rectangle& here) {
    Range& range = kept[axis][here.number];
    if (2 * here.number >= kept[axis].size()) {
      Evaluation evaluation{.noise_generator = p.noise_generator};
      return range = range_in(axis, here, evaluation);
    }
    const std::array<Rectangle, 2> halves = here.halves();
    const Range a = precompute(axis, halves[0]);
    const Range b = precompute(axis, halves[1]);
    return range = {std::min(a.low, b.low), std::max(a.high, b.high)};
  }

  /// Whether the ray may meet the surface of a rectangle between two depths and before the nearest that was found. `depth`:
  /// where, at the nearest; `longest`: over which part of the ray.
  bool may_meet(const Ray& ray, const Rectangle& here, const Range& part, double nearest, Evaluation& evaluation, double& depth,
                double& longest) const {
    std::array<Slab, 3> slabs;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = range(axis, here, evaluation);
      const double o = ray.origin[static_cast<int>(axis)];
      const double d = ray.direction[static_cast<int>(axis)];
      Slab& slab = slabs[axis];
      slab.is_along = std::abs(d) < kEpsilon;
      if (slab.is_along) {
        if (high < o || low > o) return false;
        continue;
      }
      slab.begin = (high - o) / d;
      slab.end = (low - o) / d;
      if (slab.begin > slab.end) std::swap(slab.begin, slab.end);
      if (slab.begin > part.high || slab.end < part.low || slab.begin > nearest) return false;
      for (std::size_t other = 0; other < axis; ++other) {
        const Slab& before = slabs[other];
        if (!before.is_along && (slab.begin > before.end || slab.end < before.begin)) return false;
      }
      depth = slab.begin;
      longest = std::max(longest, slab.end - slab.begin);
    }
    return true;
  }
};

}  // namespace

ShapePtr make_parametric(const ParametricParameters& parameters) {
  return std::make_shared<Placed<Parametric>>(Parametric(parameters), Transform());
}

}  // namespace firstlight::render
