// Equations of the pieces of sphere sweeps along rays, over a lane type. Included once for each instruction set, so the
// guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_SHAPE_SWEEP_SEGMENT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_SHAPE_SWEEP_SEGMENT_INL_H
#undef FIRSTLIGHT_RENDER_SHAPE_SWEEP_SEGMENT_INL_H
#else
#define FIRSTLIGHT_RENDER_SHAPE_SWEEP_SEGMENT_INL_H
#endif

#include "render/shape/lane_shape-inl.h"
#include "render/shape/sweep_segment.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

// Limits below which POV-Ray takes numbers for 0 here: a leading coefficient or a discriminant, and a slope.
constexpr double kSmall = 1e-10;
constexpr double kRightAngle = 1e-4;
constexpr double kAcross = 1e-4;  ///< a ray's slope along a curve that counts as none, over the curve's speed

/// A SweepBall of each lane.
template <class L>
struct BallOf {
  Vec3Of<L> center;
  L radius;
};

template <class L>
HWY_INLINE BallOf<L> everywhere(const SweepBall& ball) {
  return {everywhere<L>(ball.center), ball.radius};
}
/// SweepSegment::ball with a place on the curve for each lane.
template <class L>
HWY_INLINE BallOf<L> ball_at(const SweepSegment& segment, const L& u) {
  BallOf<L> sum = everywhere<L>(segment.coefficients[segment.order]);
  for (std::size_t i = segment.order; i-- > 0;) {
    const BallOf<L> c = everywhere<L>(segment.coefficients[i]);
    sum = {sum.center * u + c.center, sum.radius * u + c.radius};
  }
  return sum;
}
/// The product in which a ball that holds the origin on its surface is 0: x x' + y y' + z z' - r r'.
template <class L>
HWY_INLINE L product(const BallOf<L>& a, const BallOf<L>& b) {
  return dot(a.center, b.center) - a.radius * b.radius;
}

/// A polynomial: the sum of c[k] x^k.
template <class L, std::size_t N>
struct Powers {
  L c[N];
};

template <class L, std::size_t N, std::size_t M>
HWY_INLINE Powers<L, N + M - 1> operator*(const Powers<L, N>& a, const Powers<L, M>& b) {
  Powers<L, N + M - 1> product;
  for (L& c : product.c) c = 0.0;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < M; ++k) product.c[i + k] = product.c[i + k] + a.c[i] * b.c[k];
  }
  return product;
}
template <class L, std::size_t N>
HWY_INLINE Powers<L, N> operator+(const Powers<L, N>& a, const Powers<L, N>& b) {
  Powers<L, N> sum;
  for (std::size_t i = 0; i < N; ++i) sum.c[i] = a.c[i] + b.c[i];
  return sum;
}
template <class L, std::size_t N>
HWY_INLINE Powers<L, N - 1> derivative(const Powers<L, N>& a) {
  Powers<L, N - 1> d;
  for (std::size_t i = 1; i < N; ++i) d.c[i - 1] = static_cast<double>(i) * a.c[i];
  return d;
}

/// The Bernstein coefficients on [0, 1] all on one side of 0: then there is no root between. A chance that is missed
/// costs time only.
template <class L, std::size_t N>
HWY_INLINE MaskOf<L> has_no_root(const Powers<L, N>& polynomial) {
  static constexpr auto kBinomials = [] {
    std::array<double, N> row{};
    row[0] = 1.0;
    for (std::size_t k = 1; k < N; ++k) row[k] = row[k - 1] * static_cast<double>(N - k) / static_cast<double>(k);
    return row;
  }();
  // b[i] = sum over k up to i of binomial(i, k) / binomial(order, k) c[k], by differences.
  L b[N];
  for (std::size_t k = 0; k < N; ++k) b[k] = polynomial.c[k] / kBinomials[k];
  auto above = b[0] >= 0.0;
  auto below = b[0] <= 0.0;
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t k = 0; k + i < N; ++k) b[k] = b[k] + b[k + 1];
    above = above & (b[0] >= 0.0);
    below = below & (b[0] <= 0.0);
  }
  return above | below;
}

/// Roots in [0, 1].
template <class L>
struct UnitRoots {
  L root[2];
  MaskOf<L> counts[2];
};

/// That of a x^2 + b x + c by POV-Ray's rule, which keeps the middle where two roots are one.
template <class L>
HWY_INLINE UnitRoots<L> quadratic_roots(const L& a, const L& b, const L& c) {
  const auto is_line = abs(a) < kSmall;
  const L sum = b / -a;
  const L discriminant = sum * sum - 4.0 * (c / a);
  const auto is_one = abs(discriminant) < kSmall;
  const L difference = sqrt(discriminant);
  const L one = select(is_line, -c / b, 0.5 * sum);
  const auto has_one = without(is_one, is_line) | without(is_line, abs(b) < kSmall);
  const auto has_two = without(discriminant > 0.0, is_one | is_line);
  UnitRoots<L> roots;
  roots.root[0] = select(has_two, 0.5 * (sum + difference), one);
  roots.root[1] = 0.5 * (sum - difference);
  roots.counts[0] = (has_one | has_two) & (roots.root[0] >= 0.0) & (roots.root[0] <= 1.0);
  roots.counts[1] = has_two & (roots.root[1] >= 0.0) & (roots.root[1] <= 1.0);
  return roots;
}

/// The powers of u in product(ball(u) - at, ball(u) - at): the square of the distance to the ball's surface, as it
/// were.
template <std::size_t kOrder, class L>
HWY_INLINE Powers<L, 2 * kOrder + 1> distance(const SweepSegment& segment, const Vec3Of<L>& at) {
  BallOf<L> c[kOrder + 1];
  for (std::size_t i = 0; i <= kOrder; ++i) c[i] = everywhere<L>(segment.coefficients[i]);
  c[0].center = c[0].center - at;
  Powers<L, 2 * kOrder + 1> sum;
  for (L& power : sum.c) power = 0.0;
  for (std::size_t i = 0; i <= kOrder; ++i) {
    for (std::size_t k = 0; k <= kOrder; ++k) sum.c[i + k] = sum.c[i + k] + product(c[i], c[k]);
  }
  return sum;
}

// Places on the curve where the ball's surface touches the whole's on a ray with a direction of unit length: at a
// depth t and a u of the ray's point p(t) = |p(t) - center(u)|^2 - radius(u)^2 = 0 = its derivative by u. The first is
// t^2 + B(u) t + D(u), its derivative B' t + D'. With the t of the second in the first: D'^2 - B B' D' + B'^2 D = 0.

/// The powers of u in B.
template <std::size_t kOrder, class L>
HWY_INLINE Powers<L, kOrder + 1> approach(const SweepSegment& segment, const RayOf<L>& ray) {
  Powers<L, kOrder + 1> b;
  for (std::size_t i = 0; i <= kOrder; ++i) {
    b.c[i] = -2.0 * dot(everywhere<L>(segment.coefficients[i].center), ray.direction);
  }
  b.c[0] = b.c[0] + 2.0 * dot(ray.origin, ray.direction);
  return b;
}

/// Two places of a straight segment, and the depths there. `is_across` are rays that meet it at a right angle: no
/// depths.
template <class L>
struct StraightTouches {
  UnitRoots<L> places;
  L depth[2];
  MaskOf<L> is_across;
};
template <class L>
HWY_INLINE StraightTouches<L> straight_touches(const SweepSegment& segment, const RayOf<L>& ray) {
  const Powers<L, 3> d = distance<1>(segment, ray.origin);
  const Powers<L, 2> b = approach<1>(segment, ray);
  const L b2 = b.c[1] * b.c[1];
  StraightTouches<L> touches;
  touches.places =
      quadratic_roots<L>(4.0 * d.c[2] * d.c[2] - b2 * d.c[2], 4.0 * d.c[2] * d.c[1] - 2.0 * b.c[1] * b.c[0] * d.c[2],
                         d.c[1] * d.c[1] - b.c[1] * b.c[0] * d.c[1] + b2 * d.c[0]);
  for (std::size_t i = 0; i < 2; ++i) {
    touches.depth[i] = -(2.0 * d.c[2] * touches.places.root[i] + d.c[1]) / b.c[1];
  }
  touches.is_across = !(abs(b.c[1]) > kRightAngle);
  return touches;
}

/// The equation of a curved segment, and those that have no root between 0 and 1. Across the curve B' is 0 all along it,
/// and the equation the square of D' = 0, which only touches 0. Near that, pairs of roots lie by about B' beside those
/// of D', where the distance is least: it is another by the square of B' only.
template <class L>
struct CurvedTouches {
  Powers<L, 11> equation;
  MaskOf<L> has_none;
  Powers<L, 6> equation_across;
  MaskOf<L> is_across;
};
template <class L>
HWY_INLINE CurvedTouches<L> curved_touches(const SweepSegment& segment, const RayOf<L>& ray) {
  const Powers<L, 7> d = distance<3>(segment, ray.origin);
  const Powers<L, 4> b = approach<3>(segment, ray);
  CurvedTouches<L> touches;
  touches.equation_across = derivative(d);
  const Powers<L, 6>& d1 = touches.equation_across;
  Powers<L, 3> b1 = derivative(b);
  double speed = 0.0;
  for (std::size_t i = 1; i <= 3; ++i) speed = std::max(speed, segment.coefficients[i].center.length());
  touches.is_across = max(max(abs(b1.c[0]), abs(b1.c[1])), abs(b1.c[2])) <= kAcross * speed;
  const Powers<L, 5> b1b1 = b1 * b1;
  for (L& c : b1.c) c = -c;
  touches.equation = d1 * d1 + (b * b1) * d1 + b1b1 * d;
  touches.has_none = has_no_root(touches.equation);
  return touches;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
