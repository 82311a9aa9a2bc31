#include "render/shape/julia_fractal.h"

#include "render/lanes/math.h"
#include "render/math/interrupt.h"
#include "render/shape/hypercomplex.h"
#include "render/shape/placed.h"
#include "render/shape/sphere.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

// POV-Ray's, as all that follows.
constexpr double kTolerance = 1e-7;  ///< of a point of the surface
constexpr double kLeastSlope = 1e-8;
constexpr double kLongestStep = 30.0;  ///< of hypercomplex sets, in units of the least
/// The most steps of one ray. A step can be so short that a depth does not feel it.
constexpr int kMostSteps = 1'000'000;
constexpr int kIterationsBetween = 100'000;  ///< questions whether the work is still wanted

double square_length(const Vec4& q) { return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w; }

/// The product of two quaternions, with k j = i.
Vec4 quaternion_product(const Vec4& a, const Vec4& b) {
  return Vec4(a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.x * b.y + a.y * b.x + a.w * b.z - a.z * b.w,
              a.x * b.z + a.z * b.x + a.y * b.w - a.w * b.y, a.x * b.w + a.w * b.x + a.z * b.y - a.y * b.z);
}
/// The same with the sums in another order.
Vec4 quaternion_product_for_cubes(const Vec4& a, const Vec4& b) {
  return Vec4(a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.x * b.y + a.y * b.x - a.z * b.w + a.w * b.z,
              a.x * b.z + a.y * b.w + a.z * b.x - a.w * b.y, a.x * b.w - a.y * b.z + a.z * b.y + a.w * b.x);
}

/// All that an iteration comes through, the starting point first.
using Orbit = std::vector<Vec4>;

// Functions that are iterated. Each has `size`, the square of a value's; `next`, the value behind `q` without the set's
// parameter; the length that a ray may step without leaving a side of the surface, from an orbit that left the set at
// value `last`; and the direction in which the last value of an orbit grows, as far as the slice goes.
//
// All sums are in POV-Ray's order. A step hangs on the one before it, so what is rounded in another way grows until
// points of the surface are elsewhere by as much as decides whether a feeler begins inside or outside.

/// q^2 and q^3 of quaternions.
template <int kPower>
struct QuaternionPower {
  static constexpr bool kMistakesZ = false;

  static double size(const Vec4& q) { return q.y * q.y + q.z * q.z + q.w * q.w + q.x * q.x; }
  Vec4 next(const Vec4& q, const Vec4&) const {
    const double d = q.y * q.y + q.z * q.z + q.w * q.w;
    const double x2 = q.x * q.x;
    if constexpr (kPower == 2) {
      const double x = 2.0 * q.x;
      return Vec4(x2 - d, x * q.y, x * q.z, x * q.w);
    }
    const double f = 3.0 * x2 - d;
    return Vec4(q.x * (x2 - 3.0 * d), q.y * f, q.z * f, q.w * f);
  }
  /// The distance to the set, estimated. [Hart, Sandin, Kauffman 1989, "Ray tracing deterministic 3-D fractals"]
  double step(const Orbit& orbit, std::size_t last, const Vec3&, double) const {
    Vec4 product = orbit[0];
    double share = 1.0 / kPower;
    for (std::size_t i = 1; i <= last; ++i) {
      product = kPower == 2 ? quaternion_product(product, orbit[i]) : quaternion_product_for_cubes(product, orbit[i]);
      share /= kPower;
    }
    const double square = size(orbit[last]);
    return share * std::sqrt(square / square_length(product)) * steady::logarithm(square);
  }
  /// The derivatives of the last value by x, y and z of the first, each times that value.
  Vec3 normal(const Orbit& orbit, std::size_t last) const {
    std::array<Vec4, 3> by = {Vec4(1, 0, 0, 0), Vec4(0, 1, 0, 0), Vec4(0, 0, 1, 0)};
    for (std::size_t i = 0; i < last; ++i) {
      for (Vec4& d : by) d = derivative(orbit[i], d);
    }
    const Vec4& q = orbit[last];
    return Vec3(by[0].dot(q), by[1].dot(q), by[2].dot(q));
  }

 private:
  static Vec4 derivative(const Vec4& q, const Vec4& n) {
    if constexpr (kPower == 2) {
      return Vec4(n.x * q.x - n.y * q.y - n.z * q.z - n.w * q.w, n.x * q.y + q.x * n.y, n.x * q.z + q.x * n.z,
                  n.x * q.w + q.x * n.w);
    }
    const double d = q.y * q.y + q.z * q.z + q.w * q.w;
    const double mixed = 2.0 * (n.y * q.y + n.z * q.z + n.w * q.w);
    const double f = 6.0 * q.x * n.x - mixed;
    const double g = 3.0 * q.x * q.x - d;
    return Vec4((n.x * (q.x * q.x - d) - q.x * mixed) * 3.0, n.y * g + q.y * f, n.z * g + q.z * f, n.w * g + q.w * f);
  }
};

/// Functions of hypercomplex numbers. `Rule` has `size` and `next`, and `grown`, what becomes of a change at a value; kGrows:
/// and by 2.
template <class Rule>
struct Hypercomplex : Rule {
  /// By how far the size grows along the ray; the least step where that says nothing.
  double step(const Orbit& orbit, std::size_t last, const Vec3& direction, double least) const {
    const double fall = -normal(orbit, last).dot(direction);
    if (!(fall > kLeastSlope)) return least;
    const double slope = 2.0 * fall;
    const double square = this->size(orbit[last]);
    return square > least * slope && square < kLongestStep * least * slope ? square / slope : least;
  }
  Vec3 normal(const Orbit& orbit, std::size_t last) const {
    Vec4 q = orbit[0];
    double growth = Rule::kGrows ? 2.0 : 1.0;
    for (std::size_t i = 1; i < last; ++i) {
      q = this->grown(q, orbit[i]);
      if (Rule::kGrows) growth *= 2.0;
    }
    const Vec4 n = orbit[last] * growth;
    return Vec3(q.x * n.x + q.y * n.y + q.z * n.z + q.w * n.w, -q.y * n.x + q.x * n.y - q.w * n.z + q.z * n.w,
                -q.z * n.x - q.w * n.y + q.x * n.z + q.y * n.w);
  }
};

struct HyperSquare {
  static constexpr bool kMistakesZ = false;
  static constexpr bool kGrows = true;
  static double size(const Vec4& q) { return (q.x * q.x + q.w * q.w) + (q.y * q.y + q.z * q.z); }
  Vec4 next(const Vec4& q, const Vec4&) const {
    Vec4 square = hyper_square(q);
    square.x = (q.x * q.x + q.w * q.w) - (q.y * q.y + q.z * q.z);
    return square;
  }
  Vec4 grown(const Vec4& change, const Vec4& q) const { return hyper_product(q, change); }
};
/// POV-Ray iterates the square here too.
struct HyperCube : HyperSquare {
  static constexpr bool kGrows = false;
  static double size(const Vec4& q) { return square_length(q); }
  Vec4 next(const Vec4& q, const Vec4&) const { return hyper_square(q); }
};
struct HyperReciprocal {
  static constexpr bool kMistakesZ = false;
  static constexpr bool kGrows = false;
  static double size(const Vec4& q) { return square_length(q); }
  /// Where there is none, the one before it.
  Vec4 next(const Vec4& q, const Vec4& before) const {
    Vec4 result = before;
    hyper_reciprocal(q, result);
    return result;
  }
  Vec4 grown(const Vec4& change, const Vec4& q) const {
    return hyper_product(change, -hyper_square(next(q, Vec4(0.0))));
  }
};
struct HyperFunction {
  /// POV-Ray asks whether a point is inside at (x, y, y), while it looks for the surface at (x, y, z).
  static constexpr bool kMistakesZ = true;
  static constexpr bool kGrows = false;
  ComplexFunction function;
  std::complex<double> exponent;
  static double size(const Vec4& q) { return square_length(q); }
  Vec4 next(const Vec4& q, const Vec4&) const { return hyper_function(q, function, exponent); }
  Vec4 grown(const Vec4& change, const Vec4& q) const { return hyper_product(next(q, Vec4(0.0)), change); }
};

/// The set in its own space.
template <class Iterated>
struct JuliaFractal {
  JuliaFractalParameters p;
  Iterated iterated;
  double radius;      ///< of a ball that holds it
  double exit_value;  ///< the square of the size from which on a value is out

  /// Source  POV-Ray 3.7: a ray steps by what is known of the distance, at least by 1 / precision; where a step changes sides,
  ///         it is halved.
  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    double depth;
    double last_depth;
    if (!meet_sphere(ray, Vec3(0.0), radius * radius, depth, last_depth) || last_depth < kTolerance) return;
    depth = std::max(depth, kTolerance);
    March march{*this, ray.direction};
    Vec3 next = ray.at(depth);
    bool is_in = march.look(next);
    if (is_in) {  // perhaps of its own surface
      next += ray.direction * (2.0 * kTolerance);
      depth += 2.0 * kTolerance;
      if (depth > last_depth) return;
      is_in = march.look(next);
    }
    for (int steps = 0; depth < last_depth && steps < kMostSteps && !march.must_leave(); ++steps) {
      const double step = std::max(march.step, 1.0 / p.precision);
      if (!(depth + step <= last_depth)) return;
      const Vec3 before = next;
      next += ray.direction * step;
      const bool was_in = is_in;
      is_in = march.look(next);
      if (is_in == was_in) {
        depth += step;
        continue;
      }
      const double next_step = march.step;
      const double found = depth + march.halve(before, step, was_in);
      const Vec3 n = march.normal();
      met.add(found * (1.0 / length), n.z < 0.0 ? 1 : 0, {n.x, n.y});
      if (!met.wants_all()) return;  // even if it is too near to count
      depth += step;
      march.step = next_step;
    }
  }
  bool inside(const Vec3& point, bool inverted) const { return March{*this, Vec3(0.0)}.holds(point) != inverted; }
  Vec3 normal(const Vec3&, const Crossing& at) const {
    const double x = at.place[0];
    const double y = at.place[1];
    const double z = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    return Vec3(x, y, at.face == 1 ? -z : z);
  }
  Box3 bounds() const { return Box3(Vec3(-radius), Vec3(radius)); }
  Box3 inside_bounds() const { return Iterated::kMistakesZ ? boundless_box() : bounds(); }

 private:
  /// A way along a ray.
  struct March {
    const JuliaFractal& set;
    Vec3 direction;
    Orbit& orbit = empty_orbit(set.p.most_iterations);
    double step = 0.0;  ///< on from the point that was looked at last
    int iterations = 0;

    static Orbit& empty_orbit(int iterations) {
      thread_local Orbit orbit;
      const auto size = static_cast<std::size_t>(iterations) + 1;
      if (orbit.size() < size) orbit.resize(size);
      return orbit;
    }

    /// Whether a point is in the set; the last value of its orbit if not.
    bool iterate(const Vec3& point, std::size_t& last) {
      const JuliaFractalParameters& p = set.p;
      const auto count = static_cast<std::size_t>(p.most_iterations);
      const Vec4& s = p.slice_normal;
      Vec4 q(point.x, point.y, point.z, (p.slice_distance - s.x * point.x - s.y * point.y - s.z * point.z) / s.w);
      Vec4 function(0.0);
      orbit[0] = q;
      for (std::size_t i = 0; i < count; ++i) {
        if (set.iterated.size(q) > set.exit_value) {
          last = i;
          iterations += static_cast<int>(i) + 1;
          return false;
        }
        function = set.iterated.next(q, function);
        q = function + p.parameter;
        orbit[i + 1] = q;
      }
      last = count;
      iterations += p.most_iterations;
      return true;
    }
    bool look(const Vec3& point) {
      std::size_t last;
      const bool is_in = iterate(point, last);
      const double least = 1.0 / set.p.precision;
      step = is_in ? least : set.iterated.step(orbit, last, direction, least);
      return is_in;
    }
    bool holds(const Vec3& point) {
      std::size_t last;
      return iterate(Iterated::kMistakesZ ? Vec3(point.x, point.y, point.y) : point, last);
    }
    /// How far behind `from` the surface is, from a step that changed sides; on the inner side of it, where the orbit then
    /// begins.
    double halve(Vec3 from, double whole, bool was_in) {
      double gone = 0.0;
      while (whole > kTolerance) {
        whole *= 0.5;
        const Vec3 middle = from + direction * whole;
        if (holds(middle) != was_in) continue;
        from = middle;
        gone += whole;
      }
      if (!was_in) {
        from += direction * whole;
        gone += whole;
      }
      holds(from);
      return gone;
    }
    /// Returns the unit normal. Values that an orbit leaving the set does not reach are those of the orbit before it,
    /// as in POV-Ray.
    Vec3 normal() const {
      const Vec3 n = set.iterated.normal(orbit, static_cast<std::size_t>(set.p.most_iterations));
      const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
      if (!(largest > 0.0) || !std::isfinite(largest)) return Vec3(1.0, 0.0, 0.0);
      return (n / largest).normalized();
    }
    bool must_leave() {
      if (iterations < kIterationsBetween) return false;
      iterations = 0;
      return Interrupt::asked();
    }
  };
};

template <class Iterated>
ShapePtr make(const JuliaFractalParameters& p, const Iterated& iterated) {
  JuliaFractal<Iterated> set{p, iterated, 4.0, 16.0};
  if (p.algebra == JuliaFractalParameters::Algebra::quaternion) {
    set.radius = std::min(2.0, 1.0 + p.parameter.length() + kTolerance);
    set.exit_value = set.radius * set.radius + kTolerance;
  }
  return std::make_shared<Placed<JuliaFractal<Iterated>>>(set, Transform());
}

}  // namespace

ShapePtr make_julia_fractal(const JuliaFractalParameters& parameters) {
  const JuliaFunction function = parameters.function;
  if (parameters.algebra == JuliaFractalParameters::Algebra::quaternion) {
    if (function == JuliaFunction::cube) return make(parameters, QuaternionPower<3>());
    return make(parameters, QuaternionPower<2>());
  }
  if (function == JuliaFunction::square) return make(parameters, Hypercomplex<HyperSquare>());
  if (function == JuliaFunction::cube) return make(parameters, Hypercomplex<HyperCube>());
  if (function == JuliaFunction::reciprocal) return make(parameters, Hypercomplex<HyperReciprocal>());
  return make(parameters, Hypercomplex<HyperFunction>{{complex_function(function), parameters.exponent}});
}

}  // namespace firstlight::render
