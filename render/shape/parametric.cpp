#include "render/shape/parametric.h"

#include "render/math/interrupt.h"
#include "render/shape/placed.h"
#include "render/shape/ray_field.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace firstlight::render {
namespace {

/// Rectangles whose bounds are kept in any case: those of so many levels, the whole being the first; of functions that
/// would take more instructions for it, of fewer.
constexpr int kKeptLevels = 11;
constexpr double kMostInstructions = 1e7;
constexpr std::size_t kMostWaiting = 120;
/// A ray that needs more meets nothing. A gradient that is far too large leaves no rectangle out.
constexpr int kMostRectangles = 300'000;
constexpr double kStartRoom = 4.0;  ///< times the accuracy, behind the container's beginning. [POV-Ray 3.7]

struct Range {
  double low;
  double high;
};

/// A rectangle of u and v. Its halves have the numbers 2 n and 2 n + 1; the whole's is 1, and numbers beyond kMostNumber are
/// not told apart.
struct Rectangle {
  static constexpr std::uint32_t kMostNumber = 10'000'000;
  using Corners = std::array<double, 4>;  ///< at (low, low), (low, high), (high, low), (high, high)

  Vec2 low;
  Vec2 high;
  std::uint32_t number = 1;
  std::array<bool, 3> is_known{};     ///< whether the corners of a coordinate are
  std::array<Corners, 3> corners{};   ///< of each coordinate
  double depth = 0.0;                 ///< where a ray meets it, at the nearest
  double stretch = 0.0;               ///< of the ray on which it may meet it, along the axis where that is longest
  double latest_begin = -kBoundless;  ///< of these stretches along the axes

  double longer_side() const { return std::max(high.x - low.x, high.y - low.y); }
  int split_axis() const { return high.y - low.y > high.x - low.x ? 1 : 0; }
  /// The lower and the upper half along the longer side, of which nothing is known.
  std::array<Rectangle, 2> halves() const {
    std::array<Rectangle, 2> both = {Rectangle{low, high}, Rectangle{low, high}};
    const int axis = split_axis();
    both[0].high[axis] = both[1].low[axis] = (high[axis] + low[axis]) / 2.0;
    both[0].number = std::min(2 * number, kMostNumber);
    both[1].number = both[0].number + 1;
    return both;
  }
};

/// Bounds a function over a side or a rectangle by its values at the ends.
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

/// How far a ray may meet a rectangle.
class Approach {
 public:
  /// `part`: the depths that count.
  Approach(const Ray& ray, const Range& part) : ray_(ray), part_(part) {}

  /// Whether it may go on with the next axis, along which the rectangle reaches over `range`.
  bool next(const Range& range, Rectangle& rectangle) {
    const int axis = count_++;
    Slab& slab = slabs_[static_cast<std::size_t>(axis)];
    const double o = ray_.origin[axis];
    const double d = ray_.direction[axis];
    slab.is_along = std::abs(d) < kEpsilon;
    if (slab.is_along) return !(range.high < o || range.low > o);
    slab.begin = (range.high - o) / d;
    slab.end = (range.low - o) / d;
    if (slab.begin > slab.end) std::swap(slab.begin, slab.end);
    if (slab.begin > part_.high || slab.end < part_.low) return false;
    for (int other = 0; other < axis; ++other) {
      const Slab& before = slabs_[static_cast<std::size_t>(other)];
      if (!before.is_along && (slab.begin > before.end || slab.end < before.begin)) return false;
    }
    rectangle.depth = slab.begin;
    rectangle.stretch = std::max(rectangle.stretch, slab.end - slab.begin);
    rectangle.latest_begin = std::max(rectangle.latest_begin, slab.begin);
    return true;
  }

 private:
  const Ray& ray_;
  Range part_;
  std::array<Slab, 3> slabs_;
  int count_ = 0;
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
        int levels = kKeptLevels;
        const double each = 4.0 * static_cast<double>(p.functions[axis]->cost());
        while (levels > 1 && std::ldexp(each, levels) > kMostInstructions) --levels;
        kept[axis].resize(std::size_t{1} << levels);
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
    const Range depths{begin, part->end};
    thread_local std::vector<Rectangle> waiting;
    waiting.clear();
    Evaluation evaluation{.noise_generator = p.noise_generator};
    add_whole(ray, depths, waiting);
    double nearest = kBoundless;
    Vec2 uv(0.0);
    for (int count = 0; !waiting.empty(); ++count) {
      if (count > kMostRectangles || (count % 64 == 0 && Interrupt::asked())) return;
      Rectangle here = waiting.back();
      waiting.pop_back();
      if (here.latest_begin > nearest) continue;
      if (!(std::min(here.longer_side(), here.stretch) < p.accuracy)) {
        if (waiting.size() < kMostWaiting) add_halves(ray, depths, here, waiting, evaluation);
      } else if (here.depth < nearest && here.depth > begin) {
        nearest = here.depth;
        uv = here.low;
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
  /// Bounds a coordinate in a rectangle whose corners are known.
  Range range_of(const Rectangle& r, const Rectangle::Corners& f) const {
    const double height = r.high.y - r.low.y;
    const double width = r.high.x - r.low.x;
    const Range first = reach(height, f[0], f[1], p.max_gradient);
    const Range last = reach(height, f[2], f[3], p.max_gradient);
    return {reach(width, first.low, last.low, p.max_gradient).low, reach(width, first.high, last.high, p.max_gradient).high};
  }
  /// A coordinate at some points of u and v. POV-Ray takes the accuracy off.
  void evaluate(std::size_t axis, std::span<const Vec2> points, FieldColumn& values, Evaluation& evaluation) const {
    std::array<FieldColumn, 3> columns;
    for (std::size_t i = 0; i < points.size(); ++i) {
      columns[0][i] = points[i].x;
      columns[1][i] = points[i].y;
      columns[2][i] = 0.0;
    }
    evaluate_field(*p.functions[axis], columns, points.size(), values, evaluation);
    for (std::size_t i = 0; i < points.size(); ++i) values[i] -= p.accuracy;
  }
  Rectangle::Corners corners_of(std::size_t axis, const Rectangle& r, Evaluation& evaluation) const {
    FieldColumn f;
    evaluate(axis, std::array{r.low, Vec2(r.low.x, r.high.y), Vec2(r.high.x, r.low.y), r.high}, f, evaluation);
    return {f[0], f[1], f[2], f[3]};
  }
  Range range_in(std::size_t axis, const Rectangle& r, Evaluation& evaluation) const {
    return range_of(r, corners_of(axis, r, evaluation));
  }

  void add_whole(const Ray& ray, const Range& depths, std::vector<Rectangle>& waiting) const {
    Rectangle whole{p.low, p.high};
    Approach approach(ray, depths);
    for (const std::vector<Range>& ranges : kept) {
      if (!approach.next(ranges[1], whole)) return;
    }
    waiting.push_back(whole);
  }
  /// Adds the halves that the ray may meet, the lower one last. `whole` may get to know its corners.
  void add_halves(const Ray& ray, const Range& depths, Rectangle& whole, std::vector<Rectangle>& waiting,
                  Evaluation& evaluation) const {
    std::array<Rectangle, 2> halves = whole.halves();
    std::array<Approach, 2> approaches = {Approach(ray, depths), Approach(ray, depths)};
    std::array<bool, 2> is_met = {true, true};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::vector<Range>& ranges = kept[axis];
      const bool is_kept = halves[1].number < ranges.size();
      if (!is_kept) share_corners(axis, whole, halves, evaluation);
      for (std::size_t i = 0; i < 2; ++i) {
        if (!is_met[i]) continue;
        const Range range = is_kept ? ranges[halves[i].number] : range_of(halves[i], halves[i].corners[axis]);
        is_met[i] = approaches[i].next(range, halves[i]);
      }
      if (!is_met[0] && !is_met[1]) return;
    }
    if (is_met[1]) waiting.push_back(halves[1]);
    if (is_met[0]) waiting.push_back(halves[0]);
  }
  /// The halves' corners are the whole's and two in the middle of its sides.
  void share_corners(std::size_t axis, Rectangle& whole, std::array<Rectangle, 2>& halves, Evaluation& evaluation) const {
    if (!whole.is_known[axis]) {
      whole.corners[axis] = corners_of(axis, whole, evaluation);
      whole.is_known[axis] = true;
    }
    const Rectangle::Corners& f = whole.corners[axis];
    FieldColumn m;
    if (whole.split_axis() == 0) {
      const double middle = halves[1].low.x;
      evaluate(axis, std::array{Vec2(middle, whole.low.y), Vec2(middle, whole.high.y)}, m, evaluation);
      halves[0].corners[axis] = {f[0], f[1], m[0], m[1]};
      halves[1].corners[axis] = {m[0], m[1], f[2], f[3]};
    } else {
      const double middle = halves[1].low.y;
      evaluate(axis, std::array{Vec2(whole.low.x, middle), Vec2(whole.high.x, middle)}, m, evaluation);
      halves[0].corners[axis] = {f[0], m[0], f[2], m[1]};
      halves[1].corners[axis] = {m[0], f[1], m[1], f[3]};
    }
    halves[0].is_known[axis] = halves[1].is_known[axis] = true;
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
};

}  // namespace

ShapePtr make_parametric(const ParametricParameters& parameters) {
  return std::make_shared<Placed<Parametric>>(Parametric(parameters), Transform());
}

}  // namespace firstlight::render
