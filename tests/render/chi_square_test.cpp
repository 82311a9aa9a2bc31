#include "render/math/chi_square.h"

#include <gtest/gtest.h>

#include <cmath>

namespace firstlight::render {
namespace {

TEST(ChiSquare, AgreesWithTables) {
  // Abramowitz & Stegun, table 26.8
  EXPECT_NEAR(chi_square_quantile(1, 0.9), 0.0157908, 1e-7);
  EXPECT_NEAR(chi_square_quantile(1, 0.05), 3.84146, 1e-5);
  EXPECT_NEAR(chi_square_quantile(9, 0.9), 4.16816, 1e-5);
  EXPECT_NEAR(chi_square_quantile(30, 0.995), 13.7867, 1e-4);
  EXPECT_NEAR(chi_square_quantile(100, 0.01), 135.807, 1e-3);
}

TEST(ChiSquare, OfTwoDegreesIsALogarithm) {
  for (const double tail : {1e-9, 0.01, 0.3, 0.9, 0.999, 1 - 1e-9}) {
    EXPECT_NEAR(chi_square_quantile(2, tail) / (-2.0 * std::log(tail)), 1.0, 1e-7) << tail;
  }
}

TEST(ChiSquare, IsNormalWhereThereAreManyDegrees) {
  const double degrees = 65535.0;
  EXPECT_NEAR(chi_square_quantile(65535, 0.5), degrees - 2.0 / 3.0, 1e-3);
  EXPECT_NEAR(chi_square_quantile(65535, 0.1), degrees + 1.2815515655 * std::sqrt(2.0 * degrees), 1.0);
}

TEST(ChiSquare, FallsAsTheTailGrows) {
  for (const int degrees : {1, 2, 5, 50, 5000}) {
    double last = INFINITY;
    for (double tail = 0.001; tail < 1.0; tail += 0.037) {
      const double x = chi_square_quantile(degrees, tail);
      EXPECT_LT(x, last);
      EXPECT_GT(x, 0.0);
      last = x;
    }
  }
}

}  // namespace
}  // namespace firstlight::render
