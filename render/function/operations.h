#pragma once

// The meaning of each operation, once for a single value and for rows of them.

#include "render/function/instruction.h"
#include "render/lanes/math.h"

#include <algorithm>
#include <climits>
#include <cmath>

namespace firstlight::render {

/// As POV-Ray's processors cut numbers: what does not fit becomes the lowest integer.
inline double cut_to_integer(double value) {
  const double whole = std::trunc(value);
  return whole >= INT_MIN && whole <= INT_MAX ? whole : INT_MIN;
}

/// By the products that POV-Ray makes of it.
inline double whole_power(double x, int exponent) {
  const double square = x * x;
  switch (exponent) {
    case 2:
      return square;
    case 3:
      return square * x;
    case 4:
      return square * square;
    case 5:
      return square * square * x;
    case 6:
      return square * square * square;
    case 7:
      return square * square * x * square;
    default: {  // 8
      const double fourth = square * square;
      return fourth * fourth;
    }
  }
}

inline double select_negative(double a, double below, double other) { return a < 0.0 ? below : other; }
inline double select(double a, double below, double equal, double above) {
  return a < 0.0 ? below : a == 0.0 ? equal : above;
}

/// Calls use(f) with the operation as a function of one number. Pre: operands() is 1.
template <class Use>
inline void with_one(const Instruction& instruction, Use use) {
  switch (instruction.operation) {
    case Operation::add_constant:
      return use([c = instruction.value](double x) { return x + c; });
    case Operation::multiply_constant:
      return use([c = instruction.value](double x) { return x * c; });
    case Operation::whole_power:
      return use([n = int{instruction.index}](double x) { return whole_power(x, n); });
    case Operation::negate:
      return use([](double x) { return -x; });
    case Operation::logical_not:
      return use([](double x) { return x == 0.0 ? 1.0 : 0.0; });
    case Operation::absolute:
      return use([](double x) { return std::abs(x); });
    case Operation::arc_cosine:
      return use([](double x) { return steady::arc_cosine(x); });
    case Operation::hyperbolic_arc_cosine:
      return use([](double x) { return steady::hyperbolic_arc_cosine(x); });
    case Operation::arc_sine:
      return use([](double x) { return steady::arc_sine(x); });
    case Operation::hyperbolic_arc_sine:
      return use([](double x) { return steady::hyperbolic_arc_sine(x); });
    case Operation::arc_tangent:
      return use([](double x) { return steady::arc_tangent(x); });
    case Operation::hyperbolic_arc_tangent:
      return use([](double x) { return steady::hyperbolic_arc_tangent(x); });
    case Operation::ceiling:
      return use([](double x) { return std::ceil(x); });
    case Operation::cosine:
      return use([](double x) { return steady::cosine(x); });
    case Operation::hyperbolic_cosine:
      return use([](double x) { return steady::hyperbolic_cosine(x); });
    case Operation::exponential:
      return use([](double x) { return steady::exponential(x); });
    case Operation::floor:
      return use([](double x) { return std::floor(x); });
    case Operation::integer:
      return use(cut_to_integer);
    case Operation::natural_logarithm:
      return use([](double x) { return steady::logarithm(x); });
    case Operation::logarithm:
      return use([](double x) { return steady::decimal_logarithm(x); });
    case Operation::sine:
      return use([](double x) { return steady::sine(x); });
    case Operation::hyperbolic_sine:
      return use([](double x) { return steady::hyperbolic_sine(x); });
    case Operation::square:
      return use([](double x) { return x * x; });
    case Operation::square_root:
      return use([](double x) { return std::sqrt(x); });
    case Operation::tangent:
      return use([](double x) { return steady::tangent(x); });
    case Operation::hyperbolic_tangent:
      return use([](double x) { return steady::hyperbolic_tangent(x); });
    default:
      return;
  }
}

/// Calls use(f) with the operation as a function of two numbers. Pre: operands() is 2.
template <class Use>
inline void with_two(Operation operation, Use use) {
  switch (operation) {
    case Operation::add:
      return use([](double x, double y) { return x + y; });
    case Operation::subtract:
      return use([](double x, double y) { return x - y; });
    case Operation::multiply:
      return use([](double x, double y) { return x * y; });
    case Operation::divide:
      return use([](double x, double y) { return x / y; });
    case Operation::power:
      return use([](double x, double y) { return steady::power(x, y); });
    case Operation::arc_tangent_of_two:
      return use([](double x, double y) { return steady::arc_tangent(x, y); });
    case Operation::remainder:
      return use([](double x, double y) { return std::fmod(x, y); });
    case Operation::integer_quotient:
      return use([](double x, double y) { return cut_to_integer(x / y); });
    case Operation::minimum:
      return use([](double x, double y) { return std::min(x, y); });
    case Operation::maximum:
      return use([](double x, double y) { return std::max(x, y); });
    case Operation::less:
      return use([](double x, double y) { return x < y ? 1.0 : 0.0; });
    case Operation::less_or_equal:
      return use([](double x, double y) { return x <= y ? 1.0 : 0.0; });
    case Operation::greater:
      return use([](double x, double y) { return x > y ? 1.0 : 0.0; });
    case Operation::greater_or_equal:
      return use([](double x, double y) { return x >= y ? 1.0 : 0.0; });
    case Operation::equal:
      return use([](double x, double y) { return x == y ? 1.0 : 0.0; });
    case Operation::not_equal:
      return use([](double x, double y) { return x != y ? 1.0 : 0.0; });
    case Operation::logical_and:
      return use([](double x, double y) { return x != 0.0 && y != 0.0 ? 1.0 : 0.0; });
    case Operation::logical_or:
      return use([](double x, double y) { return x != 0.0 || y != 0.0 ? 1.0 : 0.0; });
    default:
      return;
  }
}

}  // namespace firstlight::render
