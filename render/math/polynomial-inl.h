// The formulas behind PolynomialRoots over a lane type: each lane has a polynomial of its own, all of one order. Included
// once for each instruction set, so the guard switches back and forth.
//
// `Order` is a std::integral_constant, or std::size_t for an order that is not known when this is compiled.
#if defined(FIRSTLIGHT_RENDER_MATH_POLYNOMIAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_MATH_POLYNOMIAL_INL_H
#undef FIRSTLIGHT_RENDER_MATH_POLYNOMIAL_INL_H
#else
#define FIRSTLIGHT_RENDER_MATH_POLYNOMIAL_INL_H
#endif

#include "render/lanes/lanes-inl.h"
#include "render/math/polynomial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// An interval is not halved further when it is so small beside its distance from 0: there two roots that are so near are
/// told apart by rounding alone.
template <class L>
HWY_INLINE MaskOf<L> is_narrow(const L& begin, const L& end) {
  return end - begin <= 0x1p-22 * max(abs(begin), abs(end));
}

constexpr double kEnough = 1e-9;  ///< a step so small, relative to the root, is the last: the error is its cube
constexpr int kMostRounds = 80;

/// 1 / (n over k), for k from 0 to n, of all n.
constexpr auto kInverseBinomials = [] {
  std::array<std::array<double, kMostOrder + 1>, kMostOrder + 1> inverse{};
  for (std::size_t n = 0; n <= kMostOrder; ++n) {
    double binomial = 1.0;
    for (std::size_t k = 0; k <= n; ++k) {
      inverse[n][k] = 1.0 / binomial;
      binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
  }
  return inverse;
}();

/// Room for the coefficients.
template <class Order>
constexpr std::size_t kCoefficients = (std::is_same_v<Order, std::size_t> ? kMostOrder : std::size_t{Order()}) + 1;

template <class L, class Order>
HWY_INLINE L value(const L* c, Order order, const L& x) {
  L sum = c[order];
  for (std::size_t i = order; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

/// Coefficients in Bernstein's basis over [begin, begin + width].
template <class L, class Order>
HWY_INLINE void find_bernstein(const L* c, Order order, const L& begin, const L& width, L* b) {
  const std::size_t n = order;
  for (std::size_t i = 0; i <= n; ++i) b[i] = c[i];
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = n; i-- > k;) b[i] = b[i] + begin * b[i + 1];
  }
  L power = 1.0;
  for (std::size_t i = 1; i <= n; ++i) {
    power = power * width;
    b[i] = b[i] * (power * kInverseBinomials[n][i]);
  }
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = n; i >= k; --i) b[i] = b[i] + b[i - 1];
  }
}

/// How the coefficients' signs change along intervals.
template <class L>
struct SignChanges {
  MaskOf<L> once;   ///< where there is one root
  MaskOf<L> often;  ///< where there may be some
  L crossing;  ///< of those with one: the share of the interval before the polygon of the coefficients crosses zero
};

template <class L, class Order>
HWY_INLINE SignChanges<L> sign_changes(const L* b, Order order) {
  L count = 0.0;
  L index = 0.0;
  L before = 0.0;
  L behind = 1.0;
  auto below_behind = b[order] < 0.0;
  for (std::size_t i = order; i-- > 0;) {
    const auto below_before = b[i] < 0.0;
    const auto changes = without(below_before | below_behind, below_before & below_behind);
    index = select(changes, L(static_cast<double>(i)), index);
    before = select(changes, b[i], before);
    behind = select(changes, b[i + 1], behind);
    count = select(changes, count + 1.0, count);
    below_behind = below_before;
  }
  return {count == 1.0, count > 1.0, (index + before / (before - behind)) / static_cast<double>(std::size_t{order})};
}

/// Changes of a single interval: by bits, and the division only where it is asked for.
template <class Order>
HWY_INLINE SignChanges<One> sign_changes(const One* b, Order order) {
  std::uint64_t below = 0;
  for (std::size_t i = 0; i <= order; ++i) below |= std::uint64_t{b[i].v < 0.0} << i;
  const std::uint64_t changes = (below ^ (below >> 1)) & ((std::uint64_t{1} << order) - 1);
  const bool is_one = changes != 0 && (changes & (changes - 1)) == 0;
  if (!is_one) return {OneMask{false}, OneMask{changes != 0}, 0.0};
  const auto i = static_cast<std::size_t>(__builtin_ctzll(changes));
  const double share =
      (static_cast<double>(i) + (b[i] / (b[i] - b[i + 1])).v) / static_cast<double>(std::size_t{order});
  return {OneMask{true}, OneMask{false}, share};
}

/// The root between `a` and `b`, where the curve changes sign: Halley's steps from x, kept in the bracket by halving.
template <class L, class Order>
HWY_INLINE L bracketed_root(const L* c, Order order, L a, L b, const MaskOf<L>& below_at_a, L x, MaskOf<L> open) {
  L root = x;
  for (int round = 0; round < kMostRounds && any(open); ++round) {
    L f = c[order];
    L slope = 0.0;
    L bend = 0.0;  // half the second derivative
    for (std::size_t i = order; i-- > 0;) {
      bend = bend * x + slope;
      slope = slope * x + f;
      f = f * x + c[i];
    }
    const auto below = f < L(0.0);
    const auto on_side_of_a = (below & below_at_a) | !(below | below_at_a);
    a = select(on_side_of_a, x, a);
    b = select(on_side_of_a, b, x);
    L next = x - f * slope / (slope * slope - f * bend);
    const auto ends = open & (abs(next - x) <= kEnough * abs(next));
    root = select(ends, select(next < a, a, select(b < next, b, next)), root);
    open = without(open, ends);
    next = select((next > a) & (next < b), next, 0.5 * (a + b));
    const auto stuck = without(open, (next > a) & (next < b));
    root = select(stuck, x, root);
    open = without(open, stuck);
    x = next;
  }
  return select(open, x, root);
}

/// Roots of lines and parabolas in an interval.
template <class L>
struct FewRoots {
  L first, second;
  MaskOf<L> has_first, has_second;
};

/// In closed form, but how many there are the signs at both ends of the interval say: where they differ there is one, and
/// of intervals that touch one alone has a root between them.
/// Source   W. Kahan, On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic, 2004: of both roots
///          of a parabola each is a quotient without cancellation.
/// c[2]: 0 of lines.
template <class L>
HWY_INLINE FewRoots<L> few_roots(const L* c, const L& low, const L& high) {
  constexpr std::integral_constant<std::size_t, 2> order;
  const L& bend = c[2];
  const auto below_low = value(c, order, low) < L(0.0);
  const auto below_high = value(c, order, high) < L(0.0);
  const L discriminant = c[1] * c[1] - 4.0 * (bend * c[0]);
  const L root = sqrt(max(discriminant, L(0.0)));
  const auto falls = c[1] < L(0.0);
  const L q = -0.5 * (c[1] + select(falls, -root, root));
  const auto in_interval = [&](const L& x) HWY_ATTR {
    const L above = select(x > low, x, low);
    return select(above < high, above, high);
  };
  // The curve rises through q / bend where it falls at 0, and else through c[0] / q.
  const auto by_bend = (falls & below_low) | !(falls | below_low);
  FewRoots<L> roots;
  roots.has_first = without(below_low | below_high, below_low & below_high);
  roots.first = in_interval(select(by_bend, q, c[0]) / select(by_bend, bend, q));
  // Two: it turns around between the ends, on the other side.
  const L slope_low = c[1] + 2.0 * (bend * low);
  const L slope_high = c[1] + 2.0 * (bend * high);
  const auto dips = without((slope_low < L(0.0)) & (slope_high > L(0.0)), below_low | below_high);
  const auto peaks = (slope_low > L(0.0)) & (slope_high < L(0.0)) & below_low & below_high;
  roots.has_second = (dips | peaks) & (discriminant > L(0.0));
  roots.second = roots.first;
  if (any(roots.has_second)) {
    const L one = in_interval(q / bend);
    const L other = in_interval(c[0] / q);
    roots.first = select(roots.has_second, min(one, other), roots.first);
    roots.second = max(one, other);
    roots.has_first = roots.has_first | roots.has_second;
  }
  return roots;
}

/// Whether quartics have two pairs of complex roots, beyond doubt by rounding.
/// Source   E. L. Rees, Graphical Discussion of the Roots of a Quartic Equation, 1922.
template <class L>
HWY_INLINE MaskOf<L> has_no_real_root(const L* quartic) {
  constexpr double kSure = 1e-8;  // relative
  const L &e = quartic[0], &d = quartic[1], &c = quartic[2], &b = quartic[3], &a = quartic[4];
  const L ae = 12.0 * a * e;
  const L bd = 3.0 * b * d;
  const L c2 = c * c;
  const L i = ae - bd + c2;
  const L size = abs(ae) + abs(bd) + c2;
  const L j = c * (6.0 * ae + 3.0 * bd - 2.0 * c2) - 27.0 * (a * d * d + b * b * e);
  const auto none_or_four = 4.0 * i * i * i - j * j > kSure * size * size * size;
  const L b2 = b * b;
  const L ac = a * c;
  const auto none = 8.0 * ac - 3.0 * b2 > kSure * (abs(ac) + b2);
  const L a2 = a * a;
  const L terms = 64.0 * a2 * a * e - 16.0 * a2 * b * d;
  const L squares = 16.0 * ac * (b2 - ac) - 3.0 * b2 * b2;
  return none_or_four & (none | (terms + squares > kSure * (abs(a2 * a * e) + abs(a2 * b * d) + ac * ac + b2 * b2)));
}

/// The bits of |x| as an integer: its logarithm to base 2, off by less than 0.0861 and never above, times 2^52.
template <class L>
HWY_INLINE L rough_logarithm(const L& x) {
  // In halves, each as the last bits of a number of 2^52 and more.
  constexpr std::int64_t kBitsOf2To52 = 0x4330000000000000;
  const L size = abs(x);
  const L high = or_bits(shift_bits_right<32>(size), kBitsOf2To52) - 0x1p52;
  const L low = or_bits(and_bits(size, 0xffffffff), kBitsOf2To52) - 0x1p52;
  return high * 0x1p32 + low;
}

/// No root is farther from 0. [Fujiwara, 1916; up to 1.2 times that]
/// Pre: the last coefficient is not 0.
template <class L, class Order>
HWY_INLINE L root_bound(const L* c, Order order) {
  constexpr double kOne = 0x1p52;
  const L last = rough_logarithm(c[order]) - 0.0861 * kOne;
  L largest = -1000.0 * kOne;
  for (std::size_t k = 1; k <= order; ++k) {
    largest = max(largest, (rough_logarithm(c[order - k]) - last) / static_cast<double>(k));
  }
  largest = trunc(min(largest, L(1000.0 * kOne)));
  // Back from the logarithm: 2^whole (1 + rest).
  const L whole = floor(largest * (1.0 / kOne));
  const L rest = (largest - whole * kOne) * (1.0 / kOne);
  return 2.0 * add_bits(1.0 + rest, shift_bits_left<52>(whole + 0x1.8p52));
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
