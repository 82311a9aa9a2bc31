#pragma once

// Arithmetic of numbers, vectors and colours as the expressions of the language have it, on values that are known.

#include "parser/text/token.h"
#include "parser/text/value.h"
#include "render/math/vec.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace firstlight::parser {

/// Numbers nearer to 0 than this are false, and nearer to each other are equal. [POV-Ray 3.7, EPSILON of its parser]
constexpr double kSmallestTrue = 1e-10;
inline bool is_true(double value) { return std::abs(value) > kSmallestTrue; }

/// A single number becomes equal components, a shorter vector is filled up with zeros.
inline void promote(Numbers& numbers, std::uint8_t terms) {
  if (numbers.size >= terms) return;
  const double fill = numbers.size == 1 ? numbers.values[0] : 0.0;
  for (std::size_t i = numbers.size; i < terms; ++i) numbers.values[i] = fill;
  numbers.size = terms;
}

/// A vector of three.
inline Numbers numbers_of(const render::Vec3& vector) { return {{vector.x, vector.y, vector.z, 0.0, 0.0}, 3, false}; }

/// POV-Ray cuts numbers to 32-bit integers; what does not fit becomes the lowest one, as its processors do it.
int to_int(double value);

inline Numbers single(double value, std::uint8_t terms) {
  Numbers result;
  result.values[0] = value;
  promote(result, terms);
  return result;
}

/// `<0, 1, 0>` and the like: `size` components, of which one is 1.
inline Numbers unit(std::size_t component, std::uint8_t size) {
  Numbers result;
  result.values[component] = 1.0;
  result.size = size;
  return result;
}

/// A function's or name's value where `terms` components are wanted. Vectors of three keep further components at zero;
/// those of two, four and five are what they are.
inline Numbers fitted(Numbers value, std::uint8_t terms) {
  if (value.size == 1) promote(value, terms);
  if (value.size == 3 && terms > 3) value.size = terms;
  return value;
}

/// `operation` in each component, of which the shorter operand gets as many as the other has.
template <class Operation>
Numbers combine(Numbers left, Numbers right, Operation operation) {
  if (left.size == 1 && right.size == 1) {  // most of them
    left.values[0] = operation(left.values[0], right.values[0]);
    left.is_color = false;
    return left;
  }
  promote(left, right.size);
  promote(right, left.size);
  for (std::size_t i = 0; i < left.size; ++i) left.values[i] = operation(left.values[i], right.values[i]);
  left.is_color = false;
  return left;
}

template <class Operation>
double combine(double left, double right, Operation operation) {
  return operation(left, right);
}

template <class Operation>
void change(Numbers& numbers, Operation operation) {
  for (std::size_t i = 0; i < numbers.size; ++i) numbers.values[i] = operation(numbers.values[i]);
}

template <class Operation>
void change(double& number, Operation operation) {
  number = operation(number);
}

inline double negated(double value) { return -value; }
inline double inverted(double value) { return is_true(value) ? 0.0 : 1.0; }

/// Order and equality as POV-Ray has them: `<` and `>` are exact, the others allow kSmallestTrue.
inline bool compare(Punctuation mark, double a, double b) {
  switch (mark) {
    case Punctuation::less:
      return a < b;
    case Punctuation::less_equal:
      return a <= b || !is_true(a - b);
    case Punctuation::equal:
      return !is_true(a - b);
    case Punctuation::not_equal:
      return is_true(a - b);
    case Punctuation::greater_equal:
      return a >= b || !is_true(a - b);
    default:
      return a > b;
  }
}

/// Truth of the comparison or the operator `&` or `|`: 1 or 0.
inline double truth(Punctuation mark, double a, double b) {
  bool holds = false;
  switch (mark) {
    case Punctuation::ampersand:
      holds = is_true(a) && is_true(b);
      break;
    case Punctuation::bar:
      holds = is_true(a) || is_true(b);
      break;
    default:
      holds = compare(mark, a, b);
      break;
  }
  return holds ? 1.0 : 0.0;
}

inline bool is_comparison(const Token& token) {
  switch (token.punctuation) {
    case Punctuation::less:
    case Punctuation::less_equal:
    case Punctuation::equal:
    case Punctuation::not_equal:
    case Punctuation::greater_equal:
    case Punctuation::greater:
      return token.kind == TokenKind::punctuation;
    default:
      return false;
  }
}

/// The component that `.x`, `.red` ... picks, counted from 0; `.gray` is none of them.
constexpr std::size_t kNoComponent = 5, kGray = 6;
std::size_t picked_component(Keyword word);

}  // namespace firstlight::parser
