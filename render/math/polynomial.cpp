#include "render/math/polynomial.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace firstlight::render {
namespace {

/// An interval is not halved further when it is so small beside its distance from 0: there two roots that are so near are
/// told apart by rounding alone.
constexpr double kNarrow = 0x1p-22;
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

template <class Order>
double value(const double* c, Order order, double x) {
  double sum = c[order];
  for (std::size_t i = order; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

/// Coefficients in Bernstein's basis over [begin, begin + width].
template <class Order>
void find_bernstein(const double* c, Order order, double begin, double width, double* b) {
  const std::size_t n = order;
  for (std::size_t i = 0; i <= n; ++i) b[i] = c[i];
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = n; i-- > k;) b[i] += begin * b[i + 1];
  }
  double power = 1.0;
  for (std::size_t i = 1; i <= n; ++i) {
    power *= width;
    b[i] *= power * kInverseBinomials[n][i];
  }
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = n; i >= k; --i) b[i] += b[i - 1];
  }
}

/// The root between `a` and `b`, where the curve changes sign: Halley's steps from x, kept in the bracket by halving.
template <class Order>
double bracketed_root(const double* c, Order order, double a, double b, bool negative_at_a, double x) {
  for (int round = 0; round < kMostRounds; ++round) {
    double f = c[order];
    double slope = 0.0;
    double bend = 0.0;  // half the second derivative
    for (std::size_t i = order; i-- > 0;) {
      bend = bend * x + slope;
      slope = slope * x + f;
      f = f * x + c[i];
    }
    if ((f < 0.0) == negative_at_a) {
      a = x;
    } else {
      b = x;
    }
    double next = x - f * slope / (slope * slope - f * bend);
    const double step = std::abs(next - x);
    if (step <= kEnough * std::abs(next)) return std::clamp(next, a, b);
    if (!(next > a && next < b)) {
      next = 0.5 * (a + b);
      if (!(next > a && next < b)) break;
    }
    x = next;
  }
  return x;
}

/// Whether a quartic has two pairs of complex roots, beyond doubt by rounding.
/// Source   E. L. Rees, Graphical Discussion of the Roots of a Quartic Equation, 1922.
bool has_no_real_root(const double* c) {
  constexpr double kSure = 1e-8;  // relative
  const auto [e, d, cc, b, a] = std::array<double, 5>{c[0], c[1], c[2], c[3], c[4]};
  const double ae = 12.0 * a * e;
  const double bd = 3.0 * b * d;
  const double c2 = cc * cc;
  const double i = ae - bd + c2;
  const double size = std::abs(ae) + std::abs(bd) + c2;
  const double j = cc * (6.0 * ae + 3.0 * bd - 2.0 * c2) - 27.0 * (a * d * d + b * b * e);
  if (!(4.0 * i * i * i - j * j > kSure * size * size * size)) return false;
  const double b2 = b * b;
  const double ac = a * cc;
  if (8.0 * ac - 3.0 * b2 > kSure * (std::abs(ac) + b2)) return true;
  const double a2 = a * a;
  const double terms = 64.0 * a2 * a * e - 16.0 * a2 * b * d;
  const double squares = 16.0 * ac * (b2 - ac) - 3.0 * b2 * b2;
  return terms + squares > kSure * (std::abs(a2 * a * e) + std::abs(a2 * b * d) + ac * ac + b2 * b2);
}

}  // namespace

template <class Order>
bool PolynomialRoots::next(Order order, double& root) {
  const double* c = c_.data();
  constexpr std::size_t kRoom = std::is_same_v<Order, std::size_t> ? kMostOrder : std::size_t{Order()};
  while (waiting_count_ > 0) {
    Interval here = waiting_[--waiting_count_];
    const double width = here.end - here.begin;
    std::array<double, kRoom + 1> b;
    find_bernstein(c, order, here.begin, width, b.data());
    const bool is_whole = halvings_left_ == kMostHalvings;
    if (is_whole) {
      here.at_begin = b[0];
      here.at_end = value(c, order, here.end);
    }
    b[0] = here.at_begin;
    b[order] = here.at_end;
    std::uint64_t negative = 0;
    for (std::size_t i = 0; i <= order; ++i) negative |= std::uint64_t{b[i] < 0.0} << i;
    const std::uint64_t changes = (negative ^ (negative >> 1)) & ((std::uint64_t{1} << order) - 1);
    if (changes == 0) continue;
    const bool negative_at_begin = here.at_begin < 0.0;
    if ((changes & (changes - 1)) == 0) {
      // The polygon of the coefficients crosses zero near the root.
      const auto i = static_cast<std::size_t>(std::countr_zero(changes));
      const double share = (static_cast<double>(i) + b[i] / (b[i] - b[i + 1])) / static_cast<double>(order);
      root = bracketed_root(c, order, here.begin, here.end, negative_at_begin, here.begin + width * share);
      return true;
    }
    const double middle = 0.5 * (here.begin + here.end);
    if (halvings_left_ == 0 || width <= kNarrow * std::max(std::abs(here.begin), std::abs(here.end))) {
      if (negative_at_begin == (here.at_end < 0.0)) continue;
      root = bracketed_root(c, order, here.begin, here.end, negative_at_begin, middle);
      return true;
    }
    if constexpr (kRoom == 4) {
      if (is_whole && has_no_real_root(c)) return false;
    }
    --halvings_left_;
    const double at_middle = value(c, order, middle);
    waiting_[waiting_count_++] = {middle, here.end, at_middle, here.at_end};
    waiting_[waiting_count_++] = {here.begin, middle, here.at_begin, at_middle};
  }
  return false;
}

bool PolynomialRoots::next(double& root) {
  if (waiting_count_ == 0) return false;
  switch (c_.size() - 1) {
    case 1:
      return next(std::integral_constant<std::size_t, 1>(), root);
    case 2:
      return next(std::integral_constant<std::size_t, 2>(), root);
    case 3:
      return next(std::integral_constant<std::size_t, 3>(), root);
    case 4:
      return next(std::integral_constant<std::size_t, 4>(), root);
    case 6:
      return next(std::integral_constant<std::size_t, 6>(), root);
    default:
      return next(c_.size() - 1, root);
  }
}

double root_bound(std::span<const double> c) {
  // The bits of a positive number, as an integer, are its logarithm to base 2, off by less than 0.0861 and never above.
  constexpr double kOne = 0x1p52;
  constexpr double kOff = 0.0861 * kOne;
  const auto logarithm = [](double x) { return static_cast<double>(std::bit_cast<std::int64_t>(std::abs(x))); };
  const std::size_t order = c.size() - 1;
  const double last = logarithm(c[order]) - kOff;
  double largest = -1000.0 * kOne;
  for (std::size_t k = 1; k <= order; ++k) {
    largest = std::max(largest, (logarithm(c[order - k]) - last) / static_cast<double>(k));
  }
  largest = std::min(largest, 1000.0 * kOne);
  return 2.0 * std::bit_cast<double>(static_cast<std::int64_t>(largest) + std::bit_cast<std::int64_t>(1.0));
}

}  // namespace firstlight::render
