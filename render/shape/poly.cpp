#include "render/shape/poly.h"

#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/poly.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/depth_roots-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#ifndef FIRSTLIGHT_RENDER_SHAPE_POLY
#define FIRSTLIGHT_RENDER_SHAPE_POLY
namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;     ///< POV-Ray's for this shape
constexpr double kInsideRoom = 1e-4;  ///< likewise, of the polynomial's value
constexpr auto kHighestOrder = static_cast<std::size_t>(PolyParameters::kHighestOrder);

/// The surface in its own space.
struct Poly {
  static constexpr bool kAsksBox = false;
  static constexpr bool kIsLarge = true;

  /// One step of Horner's scheme: the sum over the powers of z grows by a number and is multiplied by z, so often. At the
  /// end of a row it is a coefficient of a power of y, and so on.
  struct Step {
    double number;
    std::uint8_t times_z = 0;
    std::uint8_t times_y = 0;
    std::uint8_t times_x = 0;
    bool ends_row = false;    ///< of one power of x and one of y
    bool ends_plane = false;  ///< of one power of x
  };

  std::size_t order = 0;    ///< highest sum of exponents
  std::vector<Step> steps;  ///< one for each coefficient that is not 0

  explicit Poly(const PolyParameters& parameters) {
    struct Term {
      int i, j, k;
      double number;
    };
    std::vector<Term> terms;
    std::size_t place = 0;
    for (int i = parameters.order; i >= 0; --i) {
      for (int j = parameters.order - i; j >= 0; --j) {
        for (int k = parameters.order - i - j; k >= 0; --k, ++place) {
          if (parameters.coefficients[place] != 0.0) terms.push_back(Term{i, j, k, parameters.coefficients[place]});
        }
      }
    }
    for (std::size_t n = 0; n < terms.size(); ++n) {
      const Term& term = terms[n];
      order = std::max(order, static_cast<std::size_t>(term.i + term.j + term.k));
      const Term next = n + 1 < terms.size() ? terms[n + 1] : Term{-1, -1, -1, 0.0};
      Step& step = steps.emplace_back();
      step.number = term.number;
      step.ends_plane = next.i != term.i;
      step.ends_row = step.ends_plane || next.j != term.j;
      step.times_z = static_cast<std::uint8_t>(step.ends_row ? term.k : term.k - next.k);
      step.times_y = static_cast<std::uint8_t>(step.ends_plane ? term.j : step.ends_row ? term.j - next.j : 0);
      step.times_x = static_cast<std::uint8_t>(!step.ends_plane ? 0 : next.i < 0 ? term.i : term.i - next.i);
    }
  }

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& point, const Crossing&) const;
  Box3 bounds() const { return boundless_box(); }
  Box3 inside_bounds() const { return boundless_box(); }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

// Numbers of several kinds can be added, and multiplied by a coordinate. A number itself:

template <class L>
struct Value {
  L number;
};

template <class L>
HWY_INLINE void clear(Value<L>& sum) {
  sum.number = 0.0;
}
template <class L>
HWY_INLINE void add(Value<L>& sum, double number) {
  sum.number = sum.number + number;
}
template <class L>
HWY_INLINE void add(Value<L>& sum, const Value<L>& other) {
  sum.number = sum.number + other.number;
}
template <class L>
HWY_INLINE void multiply(Value<L>& product, const L& factor) {
  product.number = product.number * factor;
}

// Along a line: c[0] + c[1] t + ... up to `order`, which is at most N.

/// A coordinate of the line: p + t d.
template <class L>
struct Line {
  L p, d;
};

template <class L, std::size_t N>
struct Series {
  L c[N + 1];
  std::size_t order;
};

/// The order, known to the compiler where it can be.
template <class L, std::size_t N>
HWY_INLINE std::size_t order_of(const Series<L, N>& sum) {
  return N < kHighestOrder ? N : sum.order;
}
template <class L, std::size_t N>
HWY_INLINE void clear(Series<L, N>& sum) {
  for (std::size_t i = 0; i <= order_of(sum); ++i) sum.c[i] = 0.0;
}
template <class L, std::size_t N>
HWY_INLINE void add(Series<L, N>& sum, double number) {
  sum.c[0] = sum.c[0] + number;
}
template <class L, std::size_t N>
HWY_INLINE void add(Series<L, N>& sum, const Series<L, N>& other) {
  for (std::size_t i = 0; i <= order_of(sum); ++i) sum.c[i] = sum.c[i] + other.c[i];
}
template <class L, std::size_t N>
HWY_INLINE void multiply(Series<L, N>& product, const Line<L>& line) {
  for (std::size_t i = order_of(product); i > 0; --i) {
    product.c[i] = product.c[i] * line.p + product.c[i - 1] * line.d;
  }
  product.c[0] = product.c[0] * line.p;
}

// A number that depends on x, y and z, and its derivatives.

template <class L>
struct Gradient {
  L number;
  L slope[3];
};

/// x, y or z itself.
template <class L>
struct Coordinate {
  L number;
  int axis;
};

template <class L>
HWY_INLINE void clear(Gradient<L>& sum) {
  sum = {0.0, {0.0, 0.0, 0.0}};
}
template <class L>
HWY_INLINE void add(Gradient<L>& sum, double number) {
  sum.number = sum.number + number;
}
template <class L>
HWY_INLINE void add(Gradient<L>& sum, const Gradient<L>& other) {
  sum.number = sum.number + other.number;
  for (int axis = 0; axis < 3; ++axis) sum.slope[axis] = sum.slope[axis] + other.slope[axis];
}
template <class L>
HWY_INLINE void multiply(Gradient<L>& product, const Coordinate<L>& factor) {
  for (L& slope : product.slope) slope = slope * factor.number;
  product.slope[factor.axis] = product.slope[factor.axis] + product.number;
  product.number = product.number * factor.number;
}

/// The polynomial, in numbers of one of these kinds. `over_x` begins as one of them, and ends as the sum.
template <class Number, class X>
HWY_INLINE void evaluate(const Poly& poly, const X& x, const X& y, const X& z, Number& over_x) {
  clear(over_x);
  Number over_z = over_x;
  Number over_y = over_x;
  for (const Poly::Step& step : poly.steps) {
    add(over_z, step.number);
    for (int i = 0; i < step.times_z; ++i) multiply(over_z, z);
    if (!step.ends_row) continue;
    add(over_y, over_z);
    clear(over_z);
    for (int i = 0; i < step.times_y; ++i) multiply(over_y, y);
    if (!step.ends_plane) continue;
    add(over_x, over_y);
    clear(over_y);
    for (int i = 0; i < step.times_x; ++i) multiply(over_x, x);
  }
}

/// All of it but its bounds. Depths are counted from the point nearest to the origin: there the coefficients keep their
/// digits.
template <std::size_t N, class L>
HWY_INLINE DepthEquation<L, N> equation_along(const Poly& poly, const RayOf<L>& given) {
  const auto [p, d, skipped, length] = near_ray(unit_ray(given));
  Series<L, N> series;
  series.order = poly.order;
  evaluate(poly, Line<L>{p.x, d.x}, Line<L>{p.y, d.y}, Line<L>{p.z, d.z}, series);
  DepthEquation<L, N> equation;
  for (std::size_t i = 0; i <= poly.order; ++i) equation.c[i] = series.c[i];
  equation.skipped = skipped;
  equation.length = length;
  return equation;
}

template <class L>
HWY_INLINE L crossing_at(const L& t, const L& length, MaskOf<L>& counts) {
  counts = t > kNearest;
  return t / length;
}

/// Sets where the roots are looked for.
template <class Equation>
HWY_INLINE void bound(Equation& equation, std::size_t order) {
  const auto farthest = root_bound(equation.c, order);
  equation.low = max(-farthest, kNearest - equation.skipped);
  equation.high = min(farthest, decltype(farthest)(kMaxDistance));
}

template <std::size_t N>
HWY_INLINE void meet(const Poly& poly, const RaysAndPlace& asked, Slots& slots) {
  DepthEquations equations;
  RaysAndPlace left = asked;
  // Along some directions the order is lower.
  for (std::size_t order = poly.order; order > 0 && left.who != 0; --order) {
    std::uint64_t lower = 0;
    equations.begin(order);
    for_each_vector(left, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
      auto equation = equation_along<N>(poly, ray);
      bound(equation, order);
      const std::uint64_t is_lower = bits(equation.c[order] == 0.0);
      lower |= (is_lower & of_vector) << i;
      equations.set(i, of_vector & ~is_lower, equation);
    });
    meet_at_roots(equations, asked, slots, crossing_at<Lanes>);
    left.who = lower;
  }
}

template <std::size_t N>
void meet(const Poly& poly, const RayOf<One>& ray, Met& met) {
  DepthEquation<One, N> equation = equation_along<N>(poly, ray);
  std::size_t order = poly.order;
  while (order > 0 && equation.c[order].v == 0.0) --order;
  if (order == 0) return;
  bound(equation, order);
  meet_at_roots(equation, order, met, crossing_at<One>);
}

/// Calls meet<N>(arguments) with the least N for the polynomial's order.
#define FIRSTLIGHT_MEET_BY_ORDER(order, ...)   \
  switch (order) {                             \
    case 2:                                    \
      return meet<2>(__VA_ARGS__);             \
    case 3:                                    \
      return meet<3>(__VA_ARGS__);             \
    case 4:                                    \
      return meet<4>(__VA_ARGS__);             \
    case 5:                                    \
      return meet<5>(__VA_ARGS__);             \
    case 6:                                    \
      return meet<6>(__VA_ARGS__);             \
    default:                                   \
      return meet<kHighestOrder>(__VA_ARGS__); \
  }

void meet_poly(const Poly& poly, const RaysAndPlace& asked, Slots& slots) {
  FIRSTLIGHT_MEET_BY_ORDER(poly.order, poly, asked, slots)
}
inline void meet_poly_one(const Poly& poly, const Ray& ray, Met& met) {
  const RayOf<One> given{everywhere<One>(ray.origin), everywhere<One>(ray.direction)};
  FIRSTLIGHT_MEET_BY_ORDER(poly.order, poly, given, met)
}
#undef FIRSTLIGHT_MEET_BY_ORDER

template <class L>
HWY_INLINE MaskOf<L> inside(const Poly& poly, const Vec3Of<L>& p, bool inverted) {
  Value<L> sum;
  evaluate(poly, p.x, p.y, p.z, sum);
  const auto is_in = sum.number < kInsideRoom;
  return inverted ? !is_in : is_in;
}

FIRSTLIGHT_INSIDE_KERNEL(Poly)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(meet_poly);
FIRSTLIGHT_INSIDE_MEMBERS(Poly)

void Poly::meet(const Ray& ray, Met& met) const { HWY_NAMESPACE::meet_poly_one(*this, ray, met); }

void Poly::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  HWY_DYNAMIC_DISPATCH(meet_poly)(*this, asked, slots);
}

Vec3 Poly::normal(const Vec3& p, const Crossing&) const {
  using Coordinate = HWY_NAMESPACE::Coordinate<One>;
  HWY_NAMESPACE::Gradient<One> sum;
  HWY_NAMESPACE::evaluate(*this, Coordinate{p.x, 0}, Coordinate{p.y, 1}, Coordinate{p.z, 2}, sum);
  const Vec3 n(sum.slope[0].v, sum.slope[1].v, sum.slope[2].v);
  return n == Vec3(0.0) ? Vec3(1.0, 0.0, 0.0) : n;
}

}  // namespace

ShapePtr make_poly(PolyParameters parameters) { return std::make_shared<Placed<Poly>>(Poly(parameters), Transform()); }

}  // namespace firstlight::render
#endif
