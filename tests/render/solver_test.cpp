#include "render/math/polynomial.h"
#include "tests/render/each_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace firstlight::render {
namespace {

/// Coefficients of (x - r0)(x - r1)...
std::vector<double> from_roots(const std::vector<double>& roots) {
  std::vector<double> c{1.0};
  for (const double root : roots) {
    std::vector<double> product(c.size() + 1, 0.0);
    for (std::size_t i = 0; i < c.size(); ++i) {
      product[i] -= root * c[i];
      product[i + 1] += c[i];
    }
    c = product;
  }
  return c;
}

std::vector<double> roots_of(const std::vector<double>& c, double low, double high) {
  std::vector<double> roots;
  PolynomialRoots search(c, low, high);
  for (double root; search.next(root);) roots.push_back(root);
  return roots;
}

void expect_roots(const std::vector<double>& c, double low, double high, const std::vector<double>& expected,
                  double tolerance) {
  const std::vector<double> roots = roots_of(c, low, high);
  ASSERT_EQ(roots.size(), expected.size());
  for (std::size_t i = 0; i < roots.size(); ++i) ASSERT_NEAR(roots[i], expected[i], tolerance);
}

TEST(PolynomialRoots, FindsFourKnownRoots) { expect_roots(from_roots({-3, -1, 2, 5}), -10, 10, {-3, -1, 2, 5}, 1e-12); }

TEST(PolynomialRoots, KeepsToTheInterval) {
  expect_roots(from_roots({-3, -1, 2, 5}), 0, 4, {2}, 1e-12);
  expect_roots(from_roots({-3, -1, 2, 5}), 2.5, 4, {}, 0.0);
  expect_roots(from_roots({-3, -1, 2, 5}), 4, 2.5, {}, 0.0);
}

TEST(PolynomialRoots, FindsNoneWhereThereIsNone) {
  expect_roots({1, 0, 2, 0, 1}, -10, 10, {}, 0.0);
  expect_roots({5, 0, 0, 0, 0}, -10, 10, {}, 0.0);
  expect_roots({0, 0, 0, 0, 0}, -10, 10, {}, 0.0);
  expect_roots({1}, 0, 1, {}, 0.0);
  expect_roots({}, 0, 1, {}, 0.0);
}

TEST(PolynomialRoots, TellsNearlyEqualRootsApart) {
  expect_roots(from_roots({-1, 1, 1.0001, 3}), -10, 10, {-1, 1, 1.0001, 3}, 1e-9);
}

TEST(PolynomialRoots, LeavesOutWhereTheCurveOnlyTouches) {
  expect_roots(from_roots({-1, 0.5, 0.5, 3}), -10, 10, {-1, 3}, 1e-12);
  expect_roots(from_roots({2, 2, 2}), -10, 10, {2}, 1e-4);
}

TEST(PolynomialRoots, ARootWhereAnIntervalIsHalvedCountsOnce) {
  expect_roots(from_roots({-2, 0, 2}), -4, 4, {-2, 0, 2}, 1e-12);
  expect_roots(from_roots({0, 1, 2, 4}), -8, 8, {0, 1, 2, 4}, 1e-12);
}

TEST(PolynomialRoots, OfIntervalsThatTouchOneHasTheRootBetweenThem) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  int at_a_root = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<double> c(static_cast<std::size_t>(2 + round % 3));
    for (double& number : c) number = between(random);
    const std::vector<double> whole = roots_of(c, -1.0, 1.0);
    std::vector<double> cuts = {between(random), 0.0};
    cuts.insert(cuts.end(), whole.begin(), whole.end());
    at_a_root += static_cast<int>(whole.size());
    for (const double cut : cuts) {
      if (!(cut > -1.0 && cut < 1.0)) continue;
      const std::size_t parts = roots_of(c, -1.0, cut).size() + roots_of(c, cut, 1.0).size();
      EXPECT_EQ(parts % 2, whole.size() % 2) << "at " << cut << " in round " << round;
    }
  }
  EXPECT_GT(at_a_root, 5000);
}

TEST(PolynomialRoots, OfParabolasAreWhereTheyAreZero) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  int two = 0;
  for (int round = 0; round < 20000; ++round) {
    const double tiny = round % 2 == 0 ? 1.0 : 1e-13;  // nearly a line
    const std::vector<double> c = {between(random), between(random), tiny * between(random)};
    const std::vector<double> roots = roots_of(c, -2.0, 2.0);
    two += roots.size() == 2;
    for (const double root : roots) EXPECT_NEAR((c[2] * root + c[1]) * root + c[0], 0.0, 1e-15);
    const double low = (c[2] * -2.0 + c[1]) * -2.0 + c[0];
    const double high = (c[2] * 2.0 + c[1]) * 2.0 + c[0];
    EXPECT_EQ(roots.size() % 2 == 1, (low < 0.0) != (high < 0.0));
  }
  EXPECT_GT(two, 1000);
}

TEST(PolynomialRoots, FindsRandomRootsOfAllOrders) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(-2.0, 2.0);
  for (int round = 0; round < 20000; ++round) {
    std::vector<double> expected(static_cast<std::size_t>(1 + round % 6));
    for (double& r : expected) r = between(random);
    std::sort(expected.begin(), expected.end());
    double gap = 1.0;
    for (std::size_t i = 1; i < expected.size(); ++i) gap = std::min(gap, expected[i] - expected[i - 1]);
    if (gap < 1e-2) continue;
    expect_roots(from_roots(expected), -3, 3, expected, 1e-8);
  }
}

TEST(PolynomialRoots, OfHighOrderAreFound) {
  const std::vector<double> c = from_roots({-2.5, -1.0, 0.25, 0.5, 1.5, 2.0, 3.0});
  expect_roots(c, -10.0, 10.0, {-2.5, -1.0, 0.25, 0.5, 1.5, 2.0, 3.0}, 1e-10);
  expect_roots(c, 0.0, 1.0, {0.25, 0.5}, 1e-12);
  std::vector<double> power(kMostOrder + 1, 0.0);
  power.front() = -1.0;
  power.back() = 1.0;
  expect_roots(power, -2.0, 2.0, {-1.0, 1.0}, 1e-12);
}

TEST(PolynomialRoots, NearZeroAreFoundInAWideInterval) {
  expect_roots(from_roots({-0.5, 0.25, 1.0, 2.0}), -1e7, 1e7, {-0.5, 0.25, 1.0, 2.0}, 1e-12);
  expect_roots(from_roots({-1e6, 0.25, 0.5, 1.0}), -1e7, 1e7, {-1e6, 0.25, 0.5, 1.0}, 1e-6);
}

TEST(PolynomialRoots, EveryWhereDoubleEnd) {
  // A square: nothing but rounding has a sign near the roots.
  std::mt19937 random(8);
  std::uniform_real_distribution<double> between(-2.0, 2.0);
  for (int round = 0; round < 2000; ++round) {
    const double a = between(random);
    const double b = between(random);
    EXPECT_EQ(roots_of(from_roots({a, a, b, b}), -3, 3).size() % 2, 0u);
  }
}

TEST(RootBound, HoldsAllRoots) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> between(-50.0, 50.0);
  for (int round = 0; round < 2000; ++round) {
    std::vector<double> roots(static_cast<std::size_t>(1 + round % 6));
    double farthest = 0.0;
    for (double& root : roots) {
      root = between(random);
      farthest = std::max(farthest, std::abs(root));
    }
    const double bound = root_bound(from_roots(roots));
    EXPECT_GE(bound, farthest);
    EXPECT_LE(bound, 32.0 * farthest);
  }
}

/// Random polynomials of one order, some with several roots close together, some without.
void fill(PolynomialColumns& polynomials, std::size_t order, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  polynomials.order = order;
  for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
    std::vector<double> roots;
    for (std::size_t k = 0; k < order; ++k) {
      const bool is_close = k > 0 && i % 3 == 0;
      roots.push_back(is_close ? roots.back() + 1e-6 * number(random) : number(random));
    }
    std::vector<double> c = from_roots(roots);
    if (i % 4 == 1) c[0] += std::abs(number(random));
    for (std::size_t k = 0; k <= order; ++k) polynomials.c[k][i] = c[k];
    polynomials.low[i] = -0.5 - 0.4 * number(random);
    polynomials.high[i] = 0.5 + 0.4 * number(random);
  }
}

TEST(RootColumns, HaveTheRootsOfEachPolynomialAlone) {
  std::mt19937 random(7);
  for_each_target([&](const std::string& target) {
    for (const std::size_t order : {1, 2, 3, 4, 5, 6, 11}) {
      SCOPED_TRACE(target + ", " + std::to_string(order));
      PolynomialColumns polynomials;
      fill(polynomials, order, random);
      constexpr std::uint64_t kSome = 0xfff3'0e5f'77ff'a9efu;
      RootColumns search(polynomials, kSome);
      std::array<std::vector<double>, kRaysAtOnce> found;
      std::size_t count = 0;
      Column<double> root;
      for (std::uint64_t open = kSome; (open = search.next(open, root)) != 0;) {
        for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
          if ((open >> i & 1) != 0) found[i].push_back(root[i]);
        }
      }
      for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
        std::vector<double> c;
        for (std::size_t k = 0; k <= order; ++k) c.push_back(polynomials.c[k][i]);
        const bool is_asked = (kSome >> i & 1) != 0;
        EXPECT_EQ(found[i], is_asked ? roots_of(c, polynomials.low[i], polynomials.high[i]) : std::vector<double>());
        count += found[i].size();
      }
      EXPECT_GT(count, 10 * order);
    }
  });
}

}  // namespace
}  // namespace firstlight::render
