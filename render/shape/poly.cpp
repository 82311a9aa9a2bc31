#include "render/shape/poly.h"

#include "render/math/polynomial.h"
#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;     ///< POV-Ray's for this shape
constexpr double kInsideRoom = 1e-4;  ///< likewise, of the polynomial's value
constexpr auto kMostCoefficients = static_cast<std::size_t>(PolyParameters::kHighestOrder) + 1;

using Series = std::array<double, kMostCoefficients>;  ///< c[k] t^k

/// Powers of a number, from 0 on.
Series powers_of(double x, int order) {
  Series powers;
  powers[0] = 1.0;
  for (int k = 1; k <= order; ++k) powers[static_cast<std::size_t>(k)] = powers[static_cast<std::size_t>(k - 1)] * x;
  return powers;
}

/// product += a * b, of orders `n` and `m`, times a number.
void add_product(const Series& a, std::size_t n, const Series& b, std::size_t m, double factor, Series& product) {
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t k = 0; k <= m; ++k) product[i + k] += factor * a[i] * b[k];
  }
}

/// (p + t d)^n for n from 0 on.
std::vector<Series> powers_of_line(double p, double d, int order) {
  std::vector<Series> powers(static_cast<std::size_t>(order) + 1, Series{});
  powers[0][0] = 1.0;
  const Series line{p, d};
  for (std::size_t n = 1; n < powers.size(); ++n) add_product(powers[n - 1], n - 1, line, 1, 1.0, powers[n]);
  return powers;
}

/// The surface in its own space.
struct Poly {
  static constexpr bool kAsksBox = false;
  static constexpr bool kIsLarge = true;
  PolyParameters parameters;

  /// Calls visit(i, j, k, coefficient) for each term x^i y^j z^k that is there.
  template <class Visit>
  void for_each_term(const Visit& visit) const {
    const int order = parameters.order;
    std::size_t term = 0;
    for (int i = order; i >= 0; --i) {
      for (int j = order - i; j >= 0; --j) {
        for (int k = order - i - j; k >= 0; --k, ++term) {
          const double c = parameters.coefficients[term];
          if (c != 0.0) {
            visit(static_cast<std::size_t>(i), static_cast<std::size_t>(j), static_cast<std::size_t>(k), c);
          }
        }
      }
    }
  }

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    // Depths are counted from the point nearest to the origin: there the coefficients keep their digits.
    const double skipped = -ray.origin.dot(ray.direction);
    const Series equation = along(ray.at(skipped), ray.direction);
    auto count = static_cast<std::size_t>(parameters.order);
    while (count > 0 && equation[count] == 0.0) --count;
    if (count == 0) return;
    // No root is farther away. [Cauchy]
    double farthest = 0.0;
    for (std::size_t k = 0; k < count; ++k) farthest = std::max(farthest, std::abs(equation[k] / equation[count]));
    const double low = std::max(-1.0 - farthest, kNearest - skipped);
    const double high = std::min(1.0 + farthest, kMaxDistance);
    std::array<double, kMostCoefficients> roots;
    const std::size_t found = polynomial_roots({equation.data(), count + 1}, low, high, roots);
    for (std::size_t i = 0; i < found; ++i) {
      const double depth = roots[i] + skipped;
      if (depth > kNearest) met.add(depth / length);
    }
  }
  bool inside(const Vec3& p, bool inverted) const {
    const Series x = powers_of(p.x, parameters.order);
    const Series y = powers_of(p.y, parameters.order);
    const Series z = powers_of(p.z, parameters.order);
    double value = 0.0;
    for_each_term([&](std::size_t i, std::size_t j, std::size_t k, double c) { value += c * x[i] * y[j] * z[k]; });
    return (value < kInsideRoom) != inverted;
  }
  Vec3 normal(const Vec3& p, const Crossing&) const {
    const Series x = powers_of(p.x, parameters.order);
    const Series y = powers_of(p.y, parameters.order);
    const Series z = powers_of(p.z, parameters.order);
    Vec3 n(0.0);
    for_each_term([&](std::size_t i, std::size_t j, std::size_t k, double c) {
      if (i > 0) n.x += static_cast<double>(i) * c * x[i - 1] * y[j] * z[k];
      if (j > 0) n.y += static_cast<double>(j) * c * x[i] * y[j - 1] * z[k];
      if (k > 0) n.z += static_cast<double>(k) * c * x[i] * y[j] * z[k - 1];
    });
    return n == Vec3(0.0) ? Vec3(1.0, 0.0, 0.0) : n;
  }
  Box3 bounds() const { return boundless_box(); }
  Box3 inside_bounds() const { return boundless_box(); }

 private:
  /// The polynomial along a line: for each power of x the sum over y, for each power of y the sum over z.
  Series along(const Vec3& p, const Vec3& d) const {
    const int order = parameters.order;
    const std::vector<Series> x = powers_of_line(p.x, d.x, order);
    const std::vector<Series> y = powers_of_line(p.y, d.y, order);
    const std::vector<Series> z = powers_of_line(p.z, d.z, order);
    Series equation{};
    std::size_t term = 0;
    for (int i = order; i >= 0; --i) {
      Series over_y{};
      bool any_y = false;
      for (int j = order - i; j >= 0; --j) {
        Series over_z{};
        bool any_z = false;
        for (int k = order - i - j; k >= 0; --k, ++term) {
          const double c = parameters.coefficients[term];
          if (c == 0.0) continue;
          any_z = true;
          for (int h = 0; h <= k; ++h) {
            over_z[static_cast<std::size_t>(h)] += c * z[static_cast<std::size_t>(k)][static_cast<std::size_t>(h)];
          }
        }
        if (!any_z) continue;
        any_y = true;
        add_product(over_z, static_cast<std::size_t>(order - i - j), y[static_cast<std::size_t>(j)],
                    static_cast<std::size_t>(j), 1.0, over_y);
      }
      if (!any_y) continue;
      add_product(over_y, static_cast<std::size_t>(order - i), x[static_cast<std::size_t>(i)],
                  static_cast<std::size_t>(i), 1.0, equation);
    }
    return equation;
  }
};

}  // namespace

ShapePtr make_poly(PolyParameters parameters) {
  return std::make_shared<Placed<Poly>>(Poly{std::move(parameters)}, Transform());
}

}  // namespace firstlight::render
