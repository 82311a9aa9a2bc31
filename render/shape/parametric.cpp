#include "render/shape/parametric.h"

#include "render/math/interrupt.h"
#include "render/shape/placed.h"
#include "render/shape/ray_field.h"
#include "render/shape/slots.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
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

/// A rectangle of u and v. Its halves have the numbers 2 n and 2 n + 1; the whole's is 1, and numbers beyond
/// kMostNumber are not told apart.
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
  void halve(std::array<Rectangle, 2>& both) const {
    for (Rectangle& half : both) {
      half.low = low;
      half.high = high;
      half.is_known = {};
      half.depth = half.stretch = 0.0;
      half.latest_begin = -kBoundless;
    }
    const int axis = split_axis();
    both[0].high[axis] = both[1].low[axis] = (high[axis] + low[axis]) / 2.0;
    both[0].number = std::min(2 * number, kMostNumber);
    both[1].number = both[0].number + 1;
  }
  std::array<Rectangle, 2> halves() const {
    std::array<Rectangle, 2> both;
    halve(both);
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
  void start() { count_ = 0; }
  /// Whether it may go on with the next axis, along which the rectangle reaches over `range`, at the depths in `part`.
  bool next(const Ray& ray, const Range& part, const Range& range, Rectangle& rectangle) {
    const int axis = count_++;
    Slab& slab = slabs_[static_cast<std::size_t>(axis)];
    const double o = ray.origin[axis];
    const double d = ray.direction[axis];
    slab.is_along = std::abs(d) < kEpsilon;
    if (slab.is_along) return !(range.high < o || range.low > o);
    slab.begin = (range.high - o) / d;
    slab.end = (range.low - o) / d;
    if (slab.begin > slab.end) std::swap(slab.begin, slab.end);
    if (slab.begin > part.high || slab.end < part.low) return false;
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
  std::array<Slab, 3> slabs_;
  int count_ = 0;
};

/// One ray's way through the rectangles that it may meet.
///
/// Source  POV-Ray 3.7: rectangles of u and v are halved as long as the ray may meet what they may reach; what is small
///         enough is met at the nearest depth of its reach along z, or the last axis that the ray does not run across.
class Walk {
 public:
  void start(const Ray& ray, const Range& depths, double accuracy) {
    ray_ = ray;
    depths_ = depths;
    accuracy_ = accuracy;
    waiting_.clear();
    nearest_ = kBoundless;
    count_ = 0;
  }
  void add(const Rectangle& rectangle) { waiting_.push_back(rectangle); }

  /// Goes on to the next rectangle that is to be halved; false when there is none.
  bool next() {
    for (; !waiting_.empty(); ++count_) {
      if (count_ > kMostRectangles) break;
      here_ = waiting_.back();
      waiting_.pop_back();
      if (here_.latest_begin > nearest_) continue;
      if (!(std::min(here_.longer_side(), here_.stretch) < accuracy_)) {
        if (waiting_.size() >= kMostWaiting) continue;
        ++count_;
        here_.halve(halves_);
        for (Approach& approach : approaches_) approach.start();
        is_met_ = {true, true};
        return true;
      }
      if (here_.depth < nearest_ && here_.depth > depths_.low) {
        nearest_ = here_.depth;
        uv_ = here_.low;
      }
    }
    if (!waiting_.empty()) nearest_ = kBoundless;
    return false;
  }
  Rectangle& here() { return here_; }
  std::array<Rectangle, 2>& halves() { return halves_; }
  /// Whether the ray may meet any of the halves, along the next axis too.
  bool meets(const std::array<Range, 2>& ranges) {
    for (std::size_t i = 0; i < 2; ++i)
      is_met_[i] = is_met_[i] && approaches_[i].next(ray_, depths_, ranges[i], halves_[i]);
    return is_met_[0] || is_met_[1];
  }
  /// The halves that are met wait, the lower one last.
  void keep_halves() {
    if (is_met_[1]) waiting_.push_back(halves_[1]);
    if (is_met_[0]) waiting_.push_back(halves_[0]);
  }

  double nearest() const { return nearest_; }
  const Vec2& uv() const { return uv_; }

 private:
  Ray ray_;
  Range depths_;
  double accuracy_;
  std::vector<Rectangle> waiting_;
  double nearest_;
  Vec2 uv_;
  int count_;
  Rectangle here_;
  std::array<Rectangle, 2> halves_;
  std::array<Approach, 2> approaches_;
  std::array<bool, 2> is_met_;
};

/// Points of u and v at which a coordinate is asked for, and its values there.
class Evaluated {
 public:
  static constexpr std::size_t kMost = 6 * kRaysAtOnce;

  std::size_t size() const { return size_; }
  void add(const Vec2& uv) {
    u_[size_] = uv.x;
    v_[size_++] = uv.y;
  }
  void add_corners(const Rectangle& r) {
    for (const Vec2& uv : {r.low, Vec2(r.low.x, r.high.y), Vec2(r.high.x, r.low.y), r.high}) add(uv);
  }
  void run(const Function& function, int noise_generator) {
    std::fill_n(zeros_.begin(), size_, 0.0);
    Evaluation evaluation{.noise_generator = noise_generator};
    evaluate_field(function, {u_.data(), v_.data(), zeros_.data()}, size_, values_.data(), evaluation);
  }
  double operator[](std::size_t i) const { return values_[i]; }

 private:
  using Row = std::array<double, kMost>;
  Row u_, v_, zeros_, values_;
  std::size_t size_ = 0;
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
        keep(axis, kept[axis].size() / 2);
        for (std::size_t number = kept[axis].size() / 2; number-- > 1;) enclose_halves(axis, number);
      } else {
        int levels = kKeptLevels;
        const double each = 4.0 * static_cast<double>(p.functions[axis]->cost());
        while (levels > 1 && std::ldexp(each, levels) > kMostInstructions) --levels;
        kept[axis].resize(std::size_t{1} << levels);
        keep(axis, 1);
      }
    }
  }

  void meet(const Ray& ray, Met& met) const {
    meet({p.container, Transform(), alone(ray), 1}, [&](std::size_t, double depth, const Vec2& uv) {
      met.add(depth, 0, {uv.x, uv.y});
    });
  }
  void meet_block(const RaysAndPlace& asked, Slots& slots) const {
    const ContainedRays contained(p.container, asked.transform, asked.rays, asked.who);
    if (contained.met == 0) return;
    Slot* const slot = slots.add(asked.shape);
    if (slot == nullptr) return;
    slot->has_places = true;
    Slot::Details& details = slot->own_details();
    meet(contained, [&](std::size_t i, double depth, const Vec2& uv) {
      slot->rays |= std::uint64_t{1} << i;
      slot->depth[i] = depth;
      details.place[0][i] = uv.x;
      details.place[1][i] = uv.y;
    });
    slots.drop_empty(slots.size() - 1);
  }
  bool inside(const Vec3&, bool) const { return false; }
  std::uint64_t inside_block(const Transform&, bool, const Columns3<double>&, std::uint64_t) const { return 0; }
  Vec3 normal(const Vec3&, const Crossing& at) const {
    SurfacePlaces places;
    places.crossing[0] = &at;
    Columns3<double> found;
    found.set(0, Vec3(0.0));
    normals(places, 0, 1, found);
    return found.vector(0);
  }
  void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const {
    std::array<Evaluated, 3> coordinates;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = first; i < end; ++i) {
        const std::array<double, 2>& uv = places.crossing[i]->place;
        coordinates[axis].add(Vec2(uv[0], uv[1]));
        coordinates[axis].add(Vec2(uv[0] + p.accuracy, uv[1]));
        coordinates[axis].add(Vec2(uv[0], uv[1] + p.accuracy));
      }
      coordinates[axis].run(*p.functions[axis], p.noise_generator);
    }
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t at = 3 * (i - first);
      const auto along = [&](std::size_t to) {
        return Vec3(coordinates[0][to] - coordinates[0][at], coordinates[1][to] - coordinates[1][at],
                    coordinates[2][to] - coordinates[2][at]);
      };
      const Vec3 n = along(at + 1).cross(along(at + 2));
      const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
      out.set(i, largest > 0.0 && std::isfinite(largest) ? n / largest : Vec3(1.0, 0.0, 0.0));
    }
  }
  Vec2 uv(const Vec3&, const Crossing& at) const { return Vec2(at.place[0], at.place[1]); }
  Box3 bounds() const { return bounds_of(p.container); }
  Box3 inside_bounds() const { return bounds(); }

 private:
  /// Calls take(i, depth, uv) for those rays that meet the surface. In each round the rays that are still on
  /// their way go to a rectangle for whose halves a function must be asked.
  template <class Take>
  void meet(const ContainedRays& contained, const Take& take) const {
    thread_local std::array<Walk, kRaysAtOnce> walks;
    std::array<std::uint64_t, 3> asking{};  // by axis: rays that ask for that coordinate
    // On from halves that are met along the axes before `axis`, or are not.
    const auto go_on = [&](std::size_t i, std::size_t axis, bool is_met) {
      Walk& walk = walks[i];
      do {
        for (; is_met && axis < 3; ++axis) {
          const std::array<Rectangle, 2>& halves = walk.halves();
          if (halves[1].number >= kept[axis].size()) {
            asking[axis] |= std::uint64_t{1} << i;
            return;
          }
          is_met = walk.meets({kept[axis][halves[0].number], kept[axis][halves[1].number]});
        }
        if (is_met) walk.keep_halves();
        axis = 0;
        is_met = true;
      } while (walk.next());
      if (walk.nearest() < contained.end[i] && walk.nearest() > 0.0) take(i, walk.nearest(), walk.uv());
    };
    for (std::uint64_t met = contained.met; met != 0; met &= met - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(met));
      const Ray ray = contained.rays.ray(i);
      const double enters = contained.begin[i], end = contained.end[i];
      const double begin = (enters == end ? 0.0 : enters) + kStartRoom * p.accuracy;
      if (begin > end) continue;
      walks[i].start(ray, {begin, end}, p.accuracy);
      if (add_whole(ray, {begin, end}, walks[i]) && walks[i].next()) go_on(i, 0, true);
    }
    while ((asking[0] | asking[1] | asking[2]) != 0 && !Interrupt::asked()) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint64_t asked = std::exchange(asking[axis], 0);
        if (asked != 0) ask(axis, asked, walks, go_on);
      }
    }
  }
  /// Evaluates a coordinate at the corners of halves, which are the whole's and two in the middle of its sides.
  template <class GoOn>
  void ask(std::size_t axis, std::uint64_t who, std::array<Walk, kRaysAtOnce>& walks, const GoOn& go_on) const {
    Evaluated values;
    for (std::uint64_t bits = who; bits != 0; bits &= bits - 1) {
      Walk& walk = walks[static_cast<std::size_t>(std::countr_zero(bits))];
      const Rectangle& whole = walk.here();
      if (!whole.is_known[axis]) values.add_corners(whole);
      const Vec2& middle = walk.halves()[1].low;
      values.add(middle);
      values.add(whole.split_axis() == 0 ? Vec2(middle.x, whole.high.y) : Vec2(whole.high.x, middle.y));
    }
    values.run(*p.functions[axis], p.noise_generator);
    std::size_t at = 0;
    for (std::uint64_t bits = who; bits != 0; bits &= bits - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(bits));
      Walk& walk = walks[i];
      const Rectangle& whole = walk.here();
      Rectangle::Corners f = whole.corners[axis];
      if (!whole.is_known[axis]) {
        f = corners(values, at);
        at += 4;
      }
      const double m[] = {value(values, at), value(values, at + 1)};
      at += 2;
      std::array<Rectangle, 2>& halves = walk.halves();
      if (whole.split_axis() == 0) {
        halves[0].corners[axis] = {f[0], f[1], m[0], m[1]};
        halves[1].corners[axis] = {m[0], m[1], f[2], f[3]};
      } else {
        halves[0].corners[axis] = {f[0], m[0], f[2], m[1]};
        halves[1].corners[axis] = {m[0], f[1], m[1], f[3]};
      }
      halves[0].is_known[axis] = halves[1].is_known[axis] = true;
      const std::array ranges = {range_of(halves[0], halves[0].corners[axis]),
                                 range_of(halves[1], halves[1].corners[axis])};
      go_on(i, axis + 1, walk.meets(ranges));
    }
  }

  /// Bounds a coordinate in a rectangle whose corners are known.
  Range range_of(const Rectangle& r, const Rectangle::Corners& f) const {
    const double height = r.high.y - r.low.y;
    const double width = r.high.x - r.low.x;
    const Range first = reach(height, f[0], f[1], p.max_gradient);
    const Range last = reach(height, f[2], f[3], p.max_gradient);
    return {reach(width, first.low, last.low, p.max_gradient).low,
            reach(width, first.high, last.high, p.max_gradient).high};
  }
  /// A coordinate as it was evaluated. POV-Ray takes the accuracy off.
  double value(const Evaluated& values, std::size_t i) const { return values[i] - p.accuracy; }
  Rectangle::Corners corners(const Evaluated& values, std::size_t i) const {
    return {value(values, i), value(values, i + 1), value(values, i + 2), value(values, i + 3)};
  }
  /// Adds the whole if the ray may meet it.
  bool add_whole(const Ray& ray, const Range& depths, Walk& walk) const {
    Rectangle whole{p.low, p.high};
    Approach approach;
    for (const std::vector<Range>& ranges : kept) {
      if (!approach.next(ray, depths, ranges[1], whole)) return false;
    }
    walk.add(whole);
    return true;
  }

  /// Keeps the bounds that meet() would find, of the rectangles with the number `first` and higher ones.
  void keep(std::size_t axis, std::size_t first) {
    std::vector<Rectangle> waiting{{p.low, p.high}};
    std::vector<Rectangle> asked;
    while (!waiting.empty()) {
      const Rectangle here = waiting.back();
      waiting.pop_back();
      if (here.number >= first) asked.push_back(here);
      if (2 * here.number < kept[axis].size()) {
        for (const Rectangle& half : here.halves()) waiting.push_back(half);
      }
      if (asked.size() < kRaysAtOnce && !waiting.empty()) continue;
      Evaluated values;
      for (const Rectangle& r : asked) values.add_corners(r);
      values.run(*p.functions[axis], p.noise_generator);
      for (std::size_t i = 0; i < asked.size(); ++i) {
        kept[axis][asked[i].number] = range_of(asked[i], corners(values, 4 * i));
      }
      asked.clear();
    }
  }
  void enclose_halves(std::size_t axis, std::size_t number) {
    const Range& a = kept[axis][2 * number];
    const Range& b = kept[axis][2 * number + 1];
    kept[axis][number] = {std::min(a.low, b.low), std::max(a.high, b.high)};
  }
};

}  // namespace

ShapePtr make_parametric(const ParametricParameters& parameters) {
  return std::make_shared<Placed<Parametric>>(Parametric(parameters), Transform());
}

}  // namespace firstlight::render
