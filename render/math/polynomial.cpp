#include "render/math/polynomial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace firstlight::render {
namespace {

template <std::size_t N>
double value(const std::array<double, N>& c, double x) {
  double sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

double value(std::span<const double> c, double x) {
  double sum = c.back();
  for (std::size_t i = c.size() - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

template <std::size_t N>
std::array<double, N - 1> derivative(const std::array<double, N>& c) {
  std::array<double, N - 1> d;
  for (std::size_t i = 1; i < N; ++i) d[i - 1] = static_cast<double>(i) * c[i];
  return d;
}

/// The root between `a` and `b`, where the curve is monotone and changes sign: Newton's steps, kept in the bracket by
/// bisection.
template <class Curve, class Slope>
double bracketed_root(const Curve& c, const Slope& slope, double a, double b, bool negative_at_a) {
  const double enough = 1e-15 * std::max({std::abs(a), std::abs(b), b - a});
  double x = 0.5 * (a + b);
  for (int round = 0; round < 80; ++round) {
    const double f = value(c, x);
    if ((f < 0.0) == negative_at_a) {
      a = x;
    } else {
      b = x;
    }
    double next = x - f / value(slope, x);
    if (!(next > a && next < b)) next = 0.5 * (a + b);
    const double step = std::abs(next - x);
    x = next;
    if (step <= enough || b - a <= enough) break;
  }
  return x;
}

/// Numerically stable quadratic formula.
int roots_between(const std::array<double, 3>& c, double low, double high, std::array<double, 2>& roots) {
  double x1;
  double x2;
  int count = 0;
  if (c[2] == 0.0) {
    if (c[1] == 0.0) return 0;
    x1 = x2 = -c[0] / c[1];
    if (x1 >= low && x1 <= high) roots[static_cast<std::size_t>(count++)] = x1;
    return count;
  }
  const double discriminant = c[1] * c[1] - 4.0 * c[2] * c[0];
  if (!(discriminant >= 0.0)) return 0;
  const double q = -0.5 * (c[1] + std::copysign(std::sqrt(discriminant), c[1]));
  x1 = q / c[2];
  x2 = q != 0.0 ? c[0] / q : x1;
  if (x1 > x2) std::swap(x1, x2);
  if (x1 >= low && x1 <= high) roots[static_cast<std::size_t>(count++)] = x1;
  if (x2 >= low && x2 <= high && x2 != x1) roots[static_cast<std::size_t>(count++)] = x2;
  return count;
}

template <std::size_t N>
int roots_between(const std::array<double, N>& c, double low, double high, std::array<double, N - 1>& roots) {
  const std::array<double, N - 1> slope = derivative(c);
  std::array<double, N - 2> turns;
  const int turn_count = roots_between(slope, low, high, turns);
  int count = 0;
  double a = low;
  bool negative_at_a = value(c, a) < 0.0;
  for (int i = 0; i <= turn_count; ++i) {
    const double b = i < turn_count ? turns[static_cast<std::size_t>(i)] : high;
    const bool negative_at_b = value(c, b) < 0.0;
    if (negative_at_a != negative_at_b) {
      roots[static_cast<std::size_t>(count++)] = bracketed_root(c, slope, a, b, negative_at_a);
    }
    a = b;
    negative_at_a = negative_at_b;
  }
  return count;
}

using Bernstein = std::array<double, kMostBernsteinOrder + 1>;

/// How often the sign changes from one to the next; 0 counts as above 0.
std::size_t sign_changes(const Bernstein& b, std::size_t order) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < order; ++i) count += (b[i] < 0.0) != (b[i + 1] < 0.0) ? 1 : 0;
  return count;
}

/// Those of the halves of an interval: `b` becomes the upper half's. [de Casteljau]
Bernstein halve(Bernstein& b, std::size_t order) {
  Bernstein lower;
  for (std::size_t i = 0; i <= order; ++i) {
    lower[i] = b[0];
    for (std::size_t k = 0; k + i < order; ++k) b[k] = 0.5 * (b[k] + b[k + 1]);
  }
  return lower;
}

}  // namespace

int quartic_roots(const std::array<double, 5>& c, double low, double high, std::array<double, 4>& roots) {
  return low < high ? roots_between(c, low, high, roots) : 0;
}

int cubic_roots(const std::array<double, 4>& c, double low, double high, std::array<double, 3>& roots) {
  return low < high ? roots_between(c, low, high, roots) : 0;
}

std::size_t polynomial_roots(std::span<const double> c, double low, double high, std::span<double> roots) {
  if (c.size() < 2 || !(low < high)) return 0;
  // The derivatives, from the polynomial itself down to a straight line, one behind the other.
  std::array<std::array<double, kMostOrder + 1>, kMostOrder> derivatives;
  const std::size_t order = c.size() - 1;
  std::copy(c.begin(), c.end(), derivatives[0].begin());
  for (std::size_t d = 1; d < order; ++d) {
    for (std::size_t i = 0; i + d <= order; ++i) {
      derivatives[d][i] = static_cast<double>(i + 1) * derivatives[d - 1][i + 1];
    }
  }
  std::array<double, kMostOrder> turns;
  std::array<double, kMostOrder> found;
  std::size_t count = 0;
  for (std::size_t d = order; d-- > 0;) {
    const std::span<const double> here{derivatives[d].data(), order - d + 1};
    const std::size_t turn_count = count;
    std::copy_n(found.begin(), turn_count, turns.begin());
    count = 0;
    double a = low;
    bool negative_at_a = value(here, a) < 0.0;
    for (std::size_t i = 0; i <= turn_count; ++i) {
      const double b = i < turn_count ? turns[i] : high;
      const bool negative_at_b = value(here, b) < 0.0;
      if (negative_at_a != negative_at_b) {
        const std::span<const double> slope =
            d + 1 < order ? std::span<const double>{derivatives[d + 1].data(), order - d}
                          : std::span<const double>{&derivatives[d][1], 1};
        found[count++] = bracketed_root(here, slope, a, b, negative_at_a);
      }
      a = b;
      negative_at_a = negative_at_b;
    }
  }
  std::copy_n(found.begin(), count, roots.begin());
  return count;
}

std::size_t bernstein_roots(std::span<const double> c, std::span<double> roots) {
  constexpr int kDeepest = 40;  // two roots that are nearer to each other are one that touches
  const std::size_t order = c.size() - 1;
  if (c.size() < 2) return 0;
  struct Part {
    double low;
    double high;
    int depth;
    Bernstein b;
  };
  std::array<Part, kDeepest + 2> waiting;  // the lowest is the last
  std::size_t parts = 1;
  waiting[0] = {0.0, 1.0, 0, {}};
  // b[i] = sum over k up to i of binomial(i, k) / binomial(order, k) c[k], by differences.
  Bernstein differences;
  double binomial = 1.0;
  for (std::size_t k = 0; k <= order; ++k) {
    differences[k] = c[k] / binomial;
    binomial *= static_cast<double>(order - k) / static_cast<double>(k + 1);
  }
  for (std::size_t i = 0; i <= order; ++i) {
    waiting[0].b[i] = differences[0];
    for (std::size_t k = 0; k + i < order; ++k) differences[k] += differences[k + 1];
  }
  std::array<double, kMostBernsteinOrder> derivative;
  for (std::size_t i = 1; i <= order; ++i) derivative[i - 1] = static_cast<double>(i) * c[i];
  const std::span<const double> slope{derivative.data(), order};
  std::size_t count = 0;
  while (parts > 0) {
    Part& part = waiting[--parts];
    const std::size_t changes = sign_changes(part.b, order);
    if (changes == 0) continue;
    if (changes == 1) {
      roots[count++] = bracketed_root(c, slope, part.low, part.high, part.b[0] < 0.0);
      if (count == order) break;
      continue;
    }
    if (part.depth == kDeepest) continue;
    const double middle = 0.5 * (part.low + part.high);
    Part lower{part.low, middle, part.depth + 1, halve(part.b, order)};
    part.low = middle;
    ++part.depth;
    waiting[++parts] = lower;
    ++parts;
  }
  return count;
}

}  // namespace firstlight::render
