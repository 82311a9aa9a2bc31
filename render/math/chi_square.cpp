#include "render/math/chi_square.h"

#include "render/lanes/math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kSmall = std::numeric_limits<double>::epsilon();
constexpr int kMostSteps = 100000;

/// log Gamma(degrees / 2); std::lgamma writes to a global.
double log_gamma_of_half(int degrees) {
  double a = degrees % 2 == 0 ? 1.0 : 0.5;
  double sum = degrees % 2 == 0 ? 0.0 : 0.5 * steady::logarithm(std::numbers::pi);
  for (; a < 0.5 * degrees; a += 1.0) sum += steady::logarithm(a);
  return sum;
}

/// The share of the gamma distribution of shape `a` that lies above x: a series for its complement where x is small, else
/// a continued fraction. `log_gamma`: of a.
double upper_tail(double a, double x, double log_gamma) {
  if (x <= 0.0) return 1.0;
  const double front = steady::exponential(a * steady::logarithm(x) - x - log_gamma);
  if (x < a + 1.0) {
    double term = 1.0 / a;
    double sum = term;
    for (int n = 1; n < kMostSteps && term > sum * kSmall; ++n) {
      term *= x / (a + n);
      sum += term;
    }
    return 1.0 - front * sum;
  }
  // Lentz's way through the fraction: its value from the ratios of neighbouring numerators and denominators.
  constexpr double kTiny = 1e-300;
  double b = x + 1.0 - a;
  double numerators = 1.0 / kTiny;
  double denominators = 1.0 / b;
  double value = denominators;
  for (int n = 1; n < kMostSteps; ++n) {
    const double part = -n * (n - a);
    b += 2.0;
    denominators = 1.0 / (part * denominators + b);
    numerators = b + part / numerators;
    const double change = denominators * numerators;
    value *= change;
    if (std::abs(change - 1.0) < kSmall) break;
  }
  return front * value;
}

}  // namespace

double chi_square_quantile(int degrees, double tail) {
  const double a = 0.5 * degrees;
  const double log_gamma = log_gamma_of_half(degrees);
  double low = 0.0;
  double high = a + 1.0;
  while (upper_tail(a, high, log_gamma) > tail && high < 1e9) high *= 2.0;
  double x = std::max(a - 2.0 / 3.0, 0.1 * a);  // near the median
  for (int round = 0; round < 200; ++round) {
    const double excess = upper_tail(a, x, log_gamma) - tail;
    (excess > 0.0 ? low : high) = x;
    const double density = steady::exponential((a - 1.0) * steady::logarithm(x) - x - log_gamma);
    double next = x + excess / density;  // Newton's step, where it stays within what is known
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool is_found = std::abs(next - x) <= 4.0 * kSmall * x;
    x = next;
    if (is_found) break;
  }
  return 2.0 * x;
}

}  // namespace firstlight::render
