#include "render/shape/superellipsoid.h"

#include "render/lanes/math.h"
#include "render/shape/box.h"
#include "render/shape/placed.h"
#include "render/shape/superellipsoid_value.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;  ///< POV-Ray's for this shape, as all that follows
constexpr double kZero = 1e-10;
constexpr double kReach = 1.01;
constexpr int kMostRounds = 20;

/// Planes between which the surface is smooth: each ray is looked at from one to the next.
const std::array<Vec3, 9> kPlanes = {Vec3(1, 1, 0),  Vec3(1, -1, 0), Vec3(1, 0, 1), Vec3(1, 0, -1), Vec3(0, 1, 1),
                                     Vec3(0, 1, -1), Vec3(1, 0, 0),  Vec3(0, 1, 0), Vec3(0, 0, 1)};
static_assert(2 * (kPlanes.size() + 2) <= std::tuple_size<SuperellipsoidValue::Several>());

struct Superellipsoid {
  using Several = SuperellipsoidValue::Several;

  SuperellipsoidValue value;

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    Several stops{};
    const std::size_t count = find_stops(ray, stops);
    if (count == 0) return;
    const auto add = [&met, l = length](double depth) {
      const double at = depth / l;
      if (!(at > kNearest && at < kMaxDistance)) return false;
      met.add(at);
      return true;
    };
    // A step behind each stop tells mostly that the surface is not met before the next.
    for (std::size_t i = 1; i < count; ++i) stops[count + i - 1] = step_behind(stops[i - 1], stops[i]);
    const Several values = value.at(ray, stops, 2 * count - 1);
    double before = values[0];
    if (std::abs(before) < kZero) add(stops[0]);
    for (std::size_t i = 1; i < count && !met.is_enough(); ++i) {
      const double here = values[i];
      if (std::abs(here) < kZero) {
        add(stops[i]);
      } else if (before * here < 0.0) {
        add(root_between(ray, stops[i - 1], before, stops[i], here));
      } else if (const std::optional<double> first =
                     first_of_two(ray, stops[i - 1], before, stops[i], values[count + i - 1])) {
        if (!add(*first)) return;
      }
      before = here;
    }
  }
  bool inside(const Vec3& point, bool inverted) const { return (value.at(point) < kEpsilon) != inverted; }
  Vec3 normal(const Vec3& point, const Crossing&) const {
    Vec3 n = point;
    double ratio = 0.0;
    double top = 0.0;
    if (n.z != 0.0) {
      top = steady::power(std::abs(n.z), value.along);
      n.z = top / n.z;
    }
    if (std::abs(point.x) > std::abs(point.y)) {
      ratio = steady::power(std::abs(point.y / point.x), value.around);
      n.x = (1.0 - top) / point.x;
      n.y = point.y != 0.0 ? (1.0 - top) * ratio / point.y : 0.0;
    } else if (point.y != 0.0) {
      ratio = steady::power(std::abs(point.x / point.y), value.around);
      n.x = point.x != 0.0 ? (1.0 - top) * ratio / point.x : 0.0;
      n.y = (1.0 - top) / point.y;
    }
    n.z *= 1.0 + ratio;
    return n;
  }
  Box3 bounds() const { return Box3(Vec3(-1.0001), Vec3(1.0001)); }
  Box3 inside_bounds() const { return bounds(); }

 private:
  /// Where the ray meets the planes, within the box about the shape, in order.
  static std::size_t find_stops(const Ray& ray, Several& stops) {
    double near = -kBoundingHuge;
    double far = kBoundingHuge;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = ray.direction[axis];
      const double o = ray.origin[axis];
      if (!(std::abs(d) > kEpsilon)) {
        if (o < -kReach || o > kReach) return 0;
        continue;
      }
      const double reach = d > 0.0 ? kReach : -kReach;
      near = std::max(near, (-reach - o) / d);
      far = std::min(far, (reach - o) / d);
    }
    if (near > far || far < kNearest) return 0;
    near = std::max(near, kNearest);
    std::size_t count = 0;
    stops[count++] = near;
    stops[count++] = far;
    const double room = kEpsilon * (far - near);
    for (const Vec3& plane : kPlanes) {
      const double approach = ray.direction.dot(plane);
      if (std::abs(approach) < kEpsilon) continue;
      const double at = -ray.origin.dot(plane) / approach;
      if (at >= near - room && at <= far + room) stops[count++] = at;
    }
    std::sort(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  /// Between two depths at which the values have different signs: the secant's guess, depths ever nearer to it on both
  /// sides, and the middle are looked at together.
  double root_between(const Ray& ray, double a, double at_a, double b, double at_b) const {
    constexpr std::size_t kTogether = 8;
    for (int round = 0; round < kMostRounds; ++round) {
      const double width = b - a;
      const double secant = a + width * (std::abs(at_a) / std::abs(at_b - at_a));
      if (std::abs(at_a) < kZero || std::abs(at_b) < kZero) return secant;
      Several depths = {secant - width / 8.0,   secant - width / 64.0, secant - width / 512.0, secant,
                        secant + width / 512.0, secant + width / 64.0, secant + width / 8.0,   a + width * 0.5};
      for (std::size_t i = 0; i < kTogether; ++i) depths[i] = std::clamp(depths[i], a, b);
      std::sort(depths.begin(), depths.begin() + kTogether);
      const Several values = value.at(ray, depths, kTogether);
      for (std::size_t i = 0; i < kTogether; ++i) {
        if (at_a * values[i] <= 0.0) {
          b = depths[i];
          at_b = values[i];
          break;
        }
        a = depths[i];
        at_a = values[i];
      }
    }
    return std::abs(at_a) < std::abs(at_b) ? a : b;
  }
  static double step_behind(double a, double b) { return a + 0.0001 * (b - a); }
  /// Between two depths at which the values have one sign there may be two roots: Newton's steps from the
  /// first. `here` is the value at step_behind(a, b).
  std::optional<double> first_of_two(const Ray& ray, double a, double at_a, double b, double here) const {
    const double start = a;
    const double at_start = at_a;
    double next = step_behind(a, b);
    const double longest = b - a;
    double value_before = at_start;
    for (int round = 0; a < b && round < kMostRounds; ++round) {
      if (round > 0) here = value.at(ray.at(next));
      if (value_before * here < 0.0) return root_between(ray, start, value_before, next, here);
      if (std::abs(here) < kZero) return next;
      if ((value_before > 0.0 && here > value_before) || (value_before < 0.0 && here < value_before)) break;
      if (here == value_before) break;
      const double step = here * (next - a) / (here - value_before);
      if (std::abs(step) > longest) break;
      value_before = here;
      a = next;
      next -= step;
    }
    return std::nullopt;
  }
};

}  // namespace

ShapePtr make_superellipsoid(double east_west, double north_south) {
  return std::make_shared<Placed<Superellipsoid>>(Superellipsoid{{2.0 / east_west, 2.0 / north_south}}, Transform());
}

}  // namespace firstlight::render
