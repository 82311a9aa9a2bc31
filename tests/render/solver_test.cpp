#include "render/math/polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace firstlight::render {
namespace {

/// Coefficients of (x - r0)(x - r1)(x - r2)(x - r3).
std::array<double, 5> from_roots(const std::array<double, 4>& r) {
  std::array<double, 5> c = {1, 0, 0, 0, 0};
  for (std::size_t n = 0; n < 4; ++n) {
    for (std::size_t i = n + 1; i > 0; --i) c[i] = c[i - 1] - r[n] * c[i];
    c[0] *= -r[n];
  }
  return c;
}

TEST(QuarticRoots, FindsFourKnownRoots) {
  std::array<double, 4> roots;
  ASSERT_EQ(quartic_roots(from_roots({-3, -1, 2, 5}), -10, 10, roots), 4);
  const std::array<double, 4> expected = {-3, -1, 2, 5};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(roots[i], expected[i], 1e-12);
}

TEST(QuarticRoots, KeepsToTheInterval) {
  std::array<double, 4> roots;
  ASSERT_EQ(quartic_roots(from_roots({-3, -1, 2, 5}), 0, 4, roots), 1);
  EXPECT_NEAR(roots[0], 2.0, 1e-12);
  EXPECT_EQ(quartic_roots(from_roots({-3, -1, 2, 5}), 2.5, 4, roots), 0);
  EXPECT_EQ(quartic_roots(from_roots({-3, -1, 2, 5}), 4, 2.5, roots), 0);
}

TEST(QuarticRoots, FindsNoneWhereThereIsNone) {
  std::array<double, 4> roots;
  EXPECT_EQ(quartic_roots({1, 0, 2, 0, 1}, -10, 10, roots), 0);
  EXPECT_EQ(quartic_roots({5, 0, 0, 0, 0}, -10, 10, roots), 0);
}

TEST(QuarticRoots, TellsNearlyEqualRootsApart) {
  std::array<double, 4> roots;
  ASSERT_EQ(quartic_roots(from_roots({-1, 1, 1.0001, 3}), -10, 10, roots), 4);
  EXPECT_NEAR(roots[1], 1.0, 1e-9);
  EXPECT_NEAR(roots[2], 1.0001, 1e-9);
}

TEST(QuarticRoots, FindsRandomRoots) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(-2.0, 2.0);
  for (int round = 0; round < 20000; ++round) {
    std::array<double, 4> expected;
    for (double& r : expected) r = between(random);
    std::sort(expected.begin(), expected.end());
    double gap = 1.0;
    for (std::size_t i = 1; i < 4; ++i) gap = std::min(gap, expected[i] - expected[i - 1]);
    if (gap < 1e-3) continue;
    std::array<double, 4> roots;
    ASSERT_EQ(quartic_roots(from_roots(expected), -3, 3, roots), 4);
    for (std::size_t i = 0; i < 4; ++i) ASSERT_NEAR(roots[i], expected[i], 1e-9);
  }
}

TEST(CubicRoots, FindsKnownRoots) {
  std::array<double, 3> roots;
  ASSERT_EQ(cubic_roots({-6, 11, -6, 1}, 0, 10, roots), 3);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(roots[i], static_cast<double>(i + 1), 1e-12);
}

TEST(BernsteinRoots, AreThoseOfThePolynomial) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> between(-1.5, 2.0);
  std::size_t all = 0;
  for (int round = 0; round < 5000; ++round) {
    const std::size_t order = 1 + static_cast<std::size_t>(round) % kMostBernsteinOrder;
    std::vector<double> c(order + 1);
    if (round % 2 == 0) {
      for (double& number : c) number = between(random);
    } else {
      c[0] = 1.0;  // a product of roots
      for (std::size_t n = 0; n < order; ++n) {
        const double root = between(random);
        for (std::size_t i = n + 1; i > 0; --i) c[i] = c[i - 1] - root * c[i];
        c[0] *= -root;
      }
    }
    std::array<double, kMostBernsteinOrder> found;
    std::array<double, kMostBernsteinOrder> expected;
    const std::size_t count = bernstein_roots(c, found);
    ASSERT_EQ(count, polynomial_roots(c, 0.0, 1.0, expected)) << round;
    for (std::size_t i = 0; i < count; ++i) ASSERT_NEAR(found[i], expected[i], 1e-6);
    all += count;
  }
  EXPECT_GT(all, 3000u);
}

TEST(BernsteinRoots, AreWhereTheSignChanges) {
  std::array<double, 3> roots;
  ASSERT_EQ(bernstein_roots(std::array{0.0, 0.5, -1.5, 1.0}, roots), 1u);  // x (x - 0.5) (x - 1): at the ends it does not
  EXPECT_NEAR(roots[0], 0.5, 1e-12);
  EXPECT_EQ(bernstein_roots(std::array{0.25, -1.0, 1.0}, roots), 0u) << "it only touches 0";
  EXPECT_EQ(bernstein_roots(std::array{0.0, 0.0, 0.0}, roots), 0u);
}

}  // namespace
}  // namespace firstlight::render
