#include "render/shape/poly.h"

#include "render/math/polynomial.h"
#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;     ///< POV-Ray's for this shape
constexpr double kInsideRoom = 1e-4;  ///< likewise, of the polynomial's value
constexpr auto kHighestOrder = static_cast<std::size_t>(PolyParameters::kHighestOrder);

/// A coordinate along a line: p + t d.
struct Line {
  double p;
  double d;
};

/// c[0] + c[1] t + ... up to an order that is known when a ray comes, and at most N.
template <std::size_t N>
struct Series {
  std::array<double, N + 1> c;
  std::size_t order = N;

  explicit Series(std::size_t highest) : order(N < kHighestOrder ? N : highest) { clear(); }
  void clear() { std::fill_n(c.begin(), size() + 1, 0.0); }
  void add(double number) { c[0] += number; }
  void add(const Series& other) {
    for (std::size_t i = 0; i <= size(); ++i) c[i] += other.c[i];
  }
  void multiply(const Line& line) {
    for (std::size_t i = size(); i > 0; --i) c[i] = c[i] * line.p + c[i - 1] * line.d;
    c[0] *= line.p;
  }

 private:
  std::size_t size() const { return N < kHighestOrder ? N : order; }
};

/// A number.
struct Value {
  double number = 0.0;

  void clear() { number = 0.0; }
  void add(double other) { number += other; }
  void add(const Value& other) { number += other.number; }
  void multiply(double factor) { number *= factor; }
};

/// A number that depends on x, y and z, and its derivatives.
struct Gradient {
  double number = 0.0;
  Vec3 slope{0.0};

  /// x, y or z itself.
  struct Coordinate {
    double number;
    int axis;
  };

  void clear() { *this = Gradient(); }
  void add(double other) { number += other; }
  void add(const Gradient& other) {
    number += other.number;
    slope += other.slope;
  }
  void multiply(const Coordinate& factor) {
    slope *= factor.number;
    slope[factor.axis] += number;
    number *= factor.number;
  }
};

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

  std::size_t order;
  std::vector<Step> steps;  ///< one for each coefficient that is not 0

  explicit Poly(const PolyParameters& parameters) : order(static_cast<std::size_t>(parameters.order)) {
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

  void meet(const Ray& given, Met& met) const {
    switch (order) {
      case 2: return meet<2>(given, met);
      case 3: return meet<3>(given, met);
      case 4: return meet<4>(given, met);
      case 5: return meet<5>(given, met);
      case 6: return meet<6>(given, met);
      default: return meet<kHighestOrder>(given, met);
    }
  }
  bool inside(const Vec3& p, bool inverted) const {
    return (evaluate(Value(), p.x, p.y, p.z).number < kInsideRoom) != inverted;
  }
  Vec3 normal(const Vec3& p, const Crossing&) const {
    using Coordinate = Gradient::Coordinate;
    const Vec3 n = evaluate(Gradient(), Coordinate{p.x, 0}, Coordinate{p.y, 1}, Coordinate{p.z, 2}).slope;
    return n == Vec3(0.0) ? Vec3(1.0, 0.0, 0.0) : n;
  }
  Box3 bounds() const { return boundless_box(); }
  Box3 inside_bounds() const { return boundless_box(); }

 private:
  /// The polynomial, in numbers of a kind that can be added and multiplied by a coordinate.
  template <class Number, class Coordinate>
  Number evaluate(Number zero, const Coordinate& x, const Coordinate& y, const Coordinate& z) const {
    Number over_z = zero;
    Number over_y = zero;
    Number over_x = std::move(zero);
    for (const Step& step : steps) {
      over_z.add(step.number);
      for (int i = 0; i < step.times_z; ++i) over_z.multiply(z);
      if (!step.ends_row) continue;
      over_y.add(over_z);
      over_z.clear();
      for (int i = 0; i < step.times_y; ++i) over_y.multiply(y);
      if (!step.ends_plane) continue;
      over_x.add(over_y);
      over_y.clear();
      for (int i = 0; i < step.times_x; ++i) over_x.multiply(x);
    }
    return over_x;
  }
  template <std::size_t N>
  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    // Depths are counted from the point nearest to the origin: there the coefficients keep their digits.
    const double skipped = -ray.origin.dot(ray.direction);
    const Vec3 p = ray.at(skipped);
    const Vec3& d = ray.direction;
    const Series<N> equation = evaluate(Series<N>(order), Line{p.x, d.x}, Line{p.y, d.y}, Line{p.z, d.z});
    std::size_t count = order;
    while (count > 0 && equation.c[count] == 0.0) --count;
    if (count == 0) return;
    const std::span<const double> c{equation.c.data(), count + 1};
    const double farthest = root_bound(c);
    PolynomialRoots roots(c, std::max(-farthest, kNearest - skipped), std::min(farthest, kMaxDistance));
    for (double t; !met.is_enough() && roots.next(t);) {
      const double depth = t + skipped;
      if (depth > kNearest) met.add(depth / length);
    }
  }
};

}  // namespace

ShapePtr make_poly(PolyParameters parameters) {
  return std::make_shared<Placed<Poly>>(Poly(parameters), Transform());
}

}  // namespace firstlight::render
