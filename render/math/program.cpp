#include "render/math/program.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

/// Points at a time: enough to make an instruction's dispatch cheap, few enough to keep the stack in the cache.
constexpr std::size_t kLanes = 32;
using Row = std::array<double, kLanes>;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// As POV-Ray's processors cut numbers: what does not fit becomes the lowest integer.
double cut(double value) {
  const double whole = std::trunc(value);
  return whole >= INT_MIN && whole <= INT_MAX ? whole : INT_MIN;
}

template <class F>
void each(Row& a, std::size_t count, F f) {
  for (std::size_t i = 0; i < count; ++i) a[i] = f(a[i]);
}

template <class F>
void each(Row& a, const Row& b, std::size_t count, F f) {
  for (std::size_t i = 0; i < count; ++i) a[i] = f(a[i], b[i]);
}

void apply_to_one(Operation operation, Row& a, std::size_t n) {
  switch (operation) {
    case Operation::negate:
      return each(a, n, [](double x) { return -x; });
    case Operation::logical_not:
      return each(a, n, [](double x) { return x == 0.0 ? 1.0 : 0.0; });
    case Operation::absolute:
      return each(a, n, [](double x) { return std::abs(x); });
    case Operation::arc_cosine:
      return each(a, n, [](double x) { return std::acos(x); });
    case Operation::hyperbolic_arc_cosine:
      return each(a, n, [](double x) { return std::acosh(x); });
    case Operation::arc_sine:
      return each(a, n, [](double x) { return std::asin(x); });
    case Operation::hyperbolic_arc_sine:
      return each(a, n, [](double x) { return std::asinh(x); });
    case Operation::arc_tangent:
      return each(a, n, [](double x) { return std::atan(x); });
    case Operation::hyperbolic_arc_tangent:
      return each(a, n, [](double x) { return std::atanh(x); });
    case Operation::ceiling:
      return each(a, n, [](double x) { return std::ceil(x); });
    case Operation::cosine:
      return each(a, n, [](double x) { return std::cos(x); });
    case Operation::hyperbolic_cosine:
      return each(a, n, [](double x) { return std::cosh(x); });
    case Operation::degrees:
      return each(a, n, [](double x) { return x / kRadiansPerDegree; });
    case Operation::exponential:
      return each(a, n, [](double x) { return std::exp(x); });
    case Operation::floor:
      return each(a, n, [](double x) { return std::floor(x); });
    case Operation::integer:
      return each(a, n, cut);
    case Operation::natural_logarithm:
      return each(a, n, [](double x) { return std::log(x); });
    case Operation::logarithm:
      return each(a, n, [](double x) { return std::log10(x); });
    case Operation::radians:
      return each(a, n, [](double x) { return x * kRadiansPerDegree; });
    case Operation::sine:
      return each(a, n, [](double x) { return std::sin(x); });
    case Operation::hyperbolic_sine:
      return each(a, n, [](double x) { return std::sinh(x); });
    case Operation::square:
      return each(a, n, [](double x) { return x * x; });
    case Operation::square_root:
      return each(a, n, [](double x) { return std::sqrt(x); });
    case Operation::tangent:
      return each(a, n, [](double x) { return std::tan(x); });
    case Operation::hyperbolic_tangent:
      return each(a, n, [](double x) { return std::tanh(x); });
    default:
      return;
  }
}

void apply_to_two(Operation operation, Row& a, const Row& b, std::size_t n) {
  const auto truth = [](bool value) { return value ? 1.0 : 0.0; };
  switch (operation) {
    case Operation::add:
      return each(a, b, n, [](double x, double y) { return x + y; });
    case Operation::subtract:
      return each(a, b, n, [](double x, double y) { return x - y; });
    case Operation::multiply:
      return each(a, b, n, [](double x, double y) { return x * y; });
    case Operation::divide:
      return each(a, b, n, [](double x, double y) { return x / y; });
    case Operation::power:
      return each(a, b, n, [](double x, double y) { return std::pow(x, y); });
    case Operation::arc_tangent_of_two:
      return each(a, b, n, [](double x, double y) { return std::atan2(x, y); });
    case Operation::remainder:
      return each(a, b, n, [](double x, double y) { return std::fmod(x, y); });
    case Operation::integer_quotient:
      return each(a, b, n, [](double x, double y) { return cut(x / y); });
    case Operation::minimum:
      return each(a, b, n, [](double x, double y) { return std::min(x, y); });
    case Operation::maximum:
      return each(a, b, n, [](double x, double y) { return std::max(x, y); });
    case Operation::less:
      return each(a, b, n, [&](double x, double y) { return truth(x < y); });
    case Operation::less_or_equal:
      return each(a, b, n, [&](double x, double y) { return truth(x <= y); });
    case Operation::greater:
      return each(a, b, n, [&](double x, double y) { return truth(x > y); });
    case Operation::greater_or_equal:
      return each(a, b, n, [&](double x, double y) { return truth(x >= y); });
    case Operation::equal:
      return each(a, b, n, [&](double x, double y) { return truth(x == y); });
    case Operation::not_equal:
      return each(a, b, n, [&](double x, double y) { return truth(x != y); });
    case Operation::logical_and:
      return each(a, b, n, [&](double x, double y) { return truth(x != 0.0 && y != 0.0); });
    case Operation::logical_or:
      return each(a, b, n, [&](double x, double y) { return truth(x != 0.0 || y != 0.0); });
    default:
      return;
  }
}

}  // namespace

int operands(Operation operation) {
  if (operation <= Operation::parameter) return 0;
  if (operation < Operation::add) return 1;
  if (operation < Operation::select_negative) return 2;
  return operation == Operation::select_negative ? 3 : 4;
}

double Program::evaluate(std::span<const double> arguments) const {
  std::vector<std::span<const double>> columns;
  columns.reserve(arguments.size());
  for (const double& argument : arguments) columns.emplace_back(&argument, 1);
  double result = 0.0;
  evaluate(columns, {&result, 1});
  return result;
}

void Program::evaluate(std::span<const std::span<const double>> arguments, std::span<double> results) const {
  std::array<Row, kDeepest> stack;
  for (std::size_t begin = 0; begin < results.size(); begin += kLanes) {
    const std::size_t count = std::min(kLanes, results.size() - begin);
    std::size_t size = 0;
    for (const Instruction& instruction : instructions_) {
      switch (operands(instruction.operation)) {
        case 0: {
          Row& row = stack[size++];
          if (instruction.operation == Operation::constant) {
            std::fill_n(row.begin(), count, instruction.value);
          } else {
            std::copy_n(arguments[instruction.index].begin() + static_cast<std::ptrdiff_t>(begin), count, row.begin());
          }
          break;
        }
        case 1:
          apply_to_one(instruction.operation, stack[size - 1], count);
          break;
        case 2:
          apply_to_two(instruction.operation, stack[size - 2], stack[size - 1], count);
          --size;
          break;
        case 3: {
          size -= 2;
          Row& a = stack[size - 1];
          for (std::size_t i = 0; i < count; ++i) a[i] = a[i] < 0.0 ? stack[size][i] : stack[size + 1][i];
          break;
        }
        default: {
          size -= 3;
          Row& a = stack[size - 1];
          for (std::size_t i = 0; i < count; ++i) {
            a[i] = a[i] < 0.0 ? stack[size][i] : a[i] == 0.0 ? stack[size + 1][i] : stack[size + 2][i];
          }
          break;
        }
      }
    }
    std::copy_n(stack[0].begin(), count, results.begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

}  // namespace firstlight::render
