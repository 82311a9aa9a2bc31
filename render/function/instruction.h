#pragma once

#include <cstdint>

namespace firstlight::render {

/// Steps of a function of numbers. The left one of two values is the one pushed first.
enum class Operation : std::uint8_t {
  constant,   ///< pushes Instruction::value
  parameter,  ///< pushes the parameter Instruction::index
  local,      ///< pushes the value in place Instruction::index of the stack: the variable of a loop
  call,       ///< of the function Instruction::index: its arguments become its result number Instruction::component
  loop,       ///< first and last become a loop: pushes the result so far, Instruction::value, or goes behind its end
  end_sum,    ///< ends a turn, going on at Instruction::index; the loop's three places become its result
  end_product,
  // one value becomes one
  add_constant,       ///< + Instruction::value
  multiply_constant,  ///< * Instruction::value
  whole_power,        ///< to the power of Instruction::index, 2 to 8, by products
  negate,
  logical_not,
  absolute,
  arc_cosine,
  hyperbolic_arc_cosine,
  arc_sine,
  hyperbolic_arc_sine,
  arc_tangent,
  hyperbolic_arc_tangent,
  ceiling,
  cosine,
  hyperbolic_cosine,
  exponential,
  floor,
  integer,
  natural_logarithm,
  logarithm,
  sine,
  hyperbolic_sine,
  square,
  square_root,
  tangent,
  hyperbolic_tangent,
  // two values become one
  add,
  subtract,
  multiply,
  divide,
  power,
  arc_tangent_of_two,
  remainder,
  integer_quotient,
  minimum,
  maximum,
  less,
  less_or_equal,
  greater,
  greater_or_equal,
  equal,
  not_equal,
  logical_and,
  logical_or,
  // three or four become one
  select_negative,  ///< of a, b, c: b where a is below 0, else c
  select,           ///< of a, b, c, d: b where a is below 0, c where it is 0, else d
};

/// Values of Instruction::component: the weighted sum of red, green and blue; MegaPOV's height field colour.
constexpr std::uint8_t kGrayComponent = 5, kHeightComponent = 6;
constexpr double kGrayWeights[] = {0.297, 0.589, 0.114};      ///< of red, green and blue, added in this order
constexpr double kHeightWeights[] = {0.996093, 1.0 / 255.0};  ///< of the sum, and of green in it

struct Instruction {
  Operation operation = Operation::constant;
  std::uint8_t component = 0;
  std::uint16_t index = 0;
  double value = 0.0;
};

/// How many values an operation without a call or a loop takes from the stack; it pushes one.
int operands(Operation operation);
/// The value of an operation on its operands. Pre: it is no call, loop or parameter.
double apply(const Instruction& instruction, const double* operands);

}  // namespace firstlight::render
