#pragma once

#include "render/shape/shape.h"

#include <cstddef>
#include <vector>

namespace firstlight::render {

/// All points where a polynomial in x, y and z is 0; inside it is negative. `cubic`, `quartic`, `poly`, `polynomial`.
///
/// Order    Coefficients by falling powers of x, then of y, then of z: x^2, xy, xz, x, y^2, yz, y, z^2, z, 1.
/// Source   POV-Ray 3.7 manual, "Poly".
struct PolyParameters {
  static constexpr int kLowestOrder = 2;
  static constexpr int kHighestOrder = 35;

  int order = 2;
  std::vector<double> coefficients;

  static std::size_t coefficient_count(int order) {
    const auto n = static_cast<std::size_t>(order);
    return (n + 1) * (n + 2) * (n + 3) / 6;
  }
  /// Place of the coefficient of x^i y^j z^k. Pre: none is negative and their sum is at most `order`.
  static std::size_t place(int order, int i, int j, int k) {
    const auto a = static_cast<std::size_t>(order - i);
    const std::size_t b = a - static_cast<std::size_t>(j);
    const std::size_t c = b - static_cast<std::size_t>(k);
    return a * (a + 1) * (a + 2) / 6 + b * (b + 1) / 2 + c;
  }
};

ShapePtr make_poly(PolyParameters parameters);

}  // namespace firstlight::render
