#include "render/lanes/math.h"

#include "render/math/columns.h"

#include <gtest/gtest.h>

#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/lane_math_test.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/hyperbolic-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

constexpr std::size_t kFunctions = 17;

/// All functions of x (and y), in the order of kRows below.
void all_functions(const Column<double>& x, const Column<double>& y, std::array<Column<double>, kFunctions>& results) {
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const Lanes a = load<Lanes>(x, i), b = load<Lanes>(y, i);
    store(exponential(a), results[0], i);
    store(logarithm(a), results[1], i);
    store(sine(a), results[2], i);
    store(cosine(a), results[3], i);
    store(tangent(a), results[4], i);
    store(arc_sine(a), results[5], i);
    store(arc_cosine(a), results[6], i);
    store(arc_tangent(a), results[7], i);
    store(power(a, b), results[8], i);
    store(arc_tangent(a, b), results[9], i);
    store(hyperbolic_sine(a), results[10], i);
    store(hyperbolic_cosine(a), results[11], i);
    store(hyperbolic_tangent(a), results[12], i);
    store(hyperbolic_arc_sine(a), results[13], i);
    store(hyperbolic_arc_cosine(a), results[14], i);
    store(hyperbolic_arc_tangent(a), results[15], i);
    store(decimal_logarithm(a), results[16], i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "tests/render/each_target.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace firstlight::render {
namespace {

HWY_EXPORT(all_functions);

using Real = long double;
struct Row {
  const char* name;
  double (*ours)(double, double);
  Real (*exact)(Real, Real);
  double bound;  ///< of the error, relative
};

constexpr Row kRows[] = {
    {"exponential", [](double x, double) { return steady::exponential(x); }, [](Real x, Real) { return std::exp(x); },
     1.3e-16},
    {"logarithm", [](double x, double) { return steady::logarithm(x); }, [](Real x, Real) { return std::log(x); },
     1.5e-16},
    {"sine", [](double x, double) { return steady::sine(x); }, [](Real x, Real) { return std::sin(x); }, 1.5e-16},
    {"cosine", [](double x, double) { return steady::cosine(x); }, [](Real x, Real) { return std::cos(x); }, 1.5e-16},
    {"tangent", [](double x, double) { return steady::tangent(x); }, [](Real x, Real) { return std::tan(x); }, 1.8e-16},
    {"arc_sine", [](double x, double) { return steady::arc_sine(x); }, [](Real x, Real) { return std::asin(x); },
     1.9e-16},
    {"arc_cosine", [](double x, double) { return steady::arc_cosine(x); }, [](Real x, Real) { return std::acos(x); },
     1.8e-16},
    {"arc_tangent", [](double x, double) { return steady::arc_tangent(x); }, [](Real x, Real) { return std::atan(x); },
     1.3e-16},
    {"power", [](double x, double y) { return steady::power(x, y); }, [](Real x, Real y) { return std::pow(x, y); },
     1.3e-15},
    {"arc_tangent of two", [](double x, double y) { return steady::arc_tangent(x, y); },
     [](Real x, Real y) { return std::atan2(x, y); }, 1.3e-16},
    {"hyperbolic sine", [](double x, double) { return steady::hyperbolic_sine(x); },
     [](Real x, Real) { return std::sinh(x); }, 4e-16},
    {"hyperbolic cosine", [](double x, double) { return steady::hyperbolic_cosine(x); },
     [](Real x, Real) { return std::cosh(x); }, 4e-16},
    {"hyperbolic tangent", [](double x, double) { return steady::hyperbolic_tangent(x); },
     [](Real x, Real) { return std::tanh(x); }, 4e-16},
    {"hyperbolic arc sine", [](double x, double) { return steady::hyperbolic_arc_sine(x); },
     [](Real x, Real) { return std::asinh(x); }, 4e-16},
    {"hyperbolic arc cosine", [](double x, double) { return steady::hyperbolic_arc_cosine(x); },
     [](Real x, Real) { return std::acosh(x); }, 4e-16},
    {"hyperbolic arc tangent", [](double x, double) { return steady::hyperbolic_arc_tangent(x); },
     [](Real x, Real) { return std::atanh(x); }, 4e-16},
    {"decimal logarithm", [](double x, double) { return steady::decimal_logarithm(x); },
     [](Real x, Real) { return std::log10(x); }, 1.3e-16},
};

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

/// Every target gives the bits of the single number, and that is the exact value but for the last digit or two.
void check(const Column<double>& x, const Column<double>& y, std::array<double, std::size(kRows)>& worst) {
  for_each_target([&](const std::string& target) {
    std::array<Column<double>, std::size(kRows)> found;
    HWY_DYNAMIC_DISPATCH(all_functions)(x, y, found);
    for (std::size_t f = 0; f < std::size(kRows); ++f) {
      for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
        EXPECT_TRUE(same(found[f][i], kRows[f].ours(x[i], y[i])))
            << target << ": " << kRows[f].name << " of " << x[i] << ", " << y[i] << ": " << found[f][i];
      }
    }
  });
  for (std::size_t f = 0; f < std::size(kRows); ++f) {
    for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
      const double ours = kRows[f].ours(x[i], y[i]);
      const Real exact = kRows[f].exact(x[i], y[i]);
      const auto rounded = static_cast<double>(exact);
      if (rounded == 0.0 || !std::isfinite(rounded)) {
        EXPECT_TRUE(same(ours, rounded)) << kRows[f].name << " of " << x[i] << ", " << y[i] << ": " << ours << " not "
                                         << rounded;
        continue;
      }
      // Below the normal numbers the last digit is a larger share.
      const Real error = std::abs(ours - exact) / std::max(std::abs(exact), Real{std::numeric_limits<double>::min()});
      worst[f] = std::max(worst[f], static_cast<double>(error));
      EXPECT_LT(error, kRows[f].bound) << kRows[f].name << " of " << x[i] << ", " << y[i] << ": " << ours;
    }
  }
}

TEST(LaneMath, RandomNumbersAreExactButForTheLastDigit) {
  std::mt19937_64 random(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  std::array<double, std::size(kRows)> worst{};
#ifdef FIRSTLIGHT_SANITIZED
  constexpr int kBlocks = 80;  // everything takes many times as long
#else
  constexpr int kBlocks = 400;
#endif
  for (int block = 0; block < kBlocks; ++block) {
    Column<double> x, y;
    for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
      switch (block % 4) {
        case 0:
          x[i] = between(-1.0, 1.0);
          y[i] = between(-5.0, 5.0);
          break;
        case 1:
          x[i] = between(-20.0, 20.0);
          y[i] = std::trunc(between(-60.0, 60.0));
          break;
        case 2:
          x[i] = std::exp2(between(-60.0, 60.0));
          y[i] = between(-10.0, 10.0);
          break;
        default:
          x[i] = between(0.0, 1.0);
          y[i] = std::exp2(between(-10.0, 10.0));
      }
    }
    check(x, y, worst);
  }
  for (std::size_t f = 0; f < std::size(kRows); ++f) RecordProperty(kRows[f].name, std::to_string(worst[f] * 1e16));
}

TEST(LaneMath, LargeAnglesAreReducedExactly) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::ldexp(1.0 + static_cast<double>(random() >> 12) * 0x1p-52, static_cast<int>(random() % 61));
    // A double's sine is exact to 64 bits in the wider numbers.
    EXPECT_NEAR(steady::sine(x), static_cast<double>(std::sin(static_cast<Real>(x))), 2e-16) << x;
    EXPECT_NEAR(steady::cosine(-x), static_cast<double>(std::cos(static_cast<Real>(-x))), 2e-16) << x;
  }
  // [the smallest of all cosines of doubles, J.-M. Muller, "Elementary functions"]
  EXPECT_NEAR(steady::cosine(6381956970095103.0 * 0x1p797), -4.68716592425462761112e-19, 1e-33);
  EXPECT_NEAR(steady::sine(1e300), -0.8178819121159085, 1e-15);
  EXPECT_NEAR(steady::sine(-1.7976931348623157e308), -0.004961954789184062, 1e-15);
}

TEST(LaneMath, SpecialCasesAreThoseOfTheLibrary) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const double kSpecial[] = {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             2.0,
                             -2.0,
                             3.0,
                             -3.0,
                             0.5,
                             -0.5,
                             1e-320,
                             1e300,
                             1e-300,
                             kInfinite,
                             -kInfinite,
                             -1e-320,
                             1e17,
                             -1e17,
                             1.5,
                             -2.5,
                             std::numeric_limits<double>::quiet_NaN(),
                             1.0000000000000002,
                             0.99999999999999989};
  constexpr std::size_t kCount = std::size(kSpecial);
  std::array<double, std::size(kRows)> worst{};
  for (std::size_t next = 0; next < kCount * kCount;) {
    Column<double> x, y;
    for (std::size_t i = 0; i < kRaysAtOnce; ++i, ++next) {
      x[i] = kSpecial[next % kCount];
      y[i] = kSpecial[next / kCount % kCount];
    }
    check(x, y, worst);
  }
}

}  // namespace
}  // namespace firstlight::render
#endif
