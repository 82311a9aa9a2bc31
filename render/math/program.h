#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace firstlight::render {

/// What a function of numbers is made of. Of two values, the one pushed first is the left one.
enum class Operation : std::uint8_t {
  constant,   ///< pushes Instruction::value
  parameter,  ///< pushes the parameter Instruction::index
  // one value becomes one
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
  degrees,
  exponential,
  floor,
  integer,
  natural_logarithm,
  logarithm,
  radians,
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
  select_negative,  ///< of a, b, c: b where a is below 0, else c
  select,           ///< of a, b, c, d: b where a is below 0, c where it is 0, else d
};

/// How many values an operation takes from the stack; it pushes one.
int operands(Operation operation);

struct Instruction {
  Operation operation = Operation::constant;
  std::uint16_t index = 0;
  double value = 0.0;
};

/// A function of some numbers, as instructions of a stack machine, for one point or for many at a time.
///
/// Source   The meaning of each operation is that of POV-Ray 3.7's functions: whatever is not 0 is true, comparisons
/// are
///          exact. What has no value is not-a-number or infinite, never an error.
/// Cost     a nanosecond or so an instruction and point, when there are many points; more for sines and the like.
/// Threads  Immutable.
class Program {
 public:
  static constexpr std::size_t kMostInstructions = 65535;
  static constexpr std::size_t kDeepest = 64;  ///< values on the stack

  /// Pre: the instructions leave one value, never take from an empty stack nor exceed kDeepest; parameters exist.
  Program(std::vector<Instruction> instructions, std::size_t parameters)
      : instructions_(std::move(instructions)), parameters_(parameters) {}

  std::size_t parameter_count() const { return parameters_; }
  std::span<const Instruction> instructions() const { return instructions_; }
  /// Pre: as many arguments as parameters.
  double evaluate(std::span<const double> arguments) const;
  /// results[i] = value at arguments[p][i] for parameter p. Pre: as many columns as parameters, each as long as
  /// results.
  void evaluate(std::span<const std::span<const double>> arguments, std::span<double> results) const;

 private:
  std::vector<Instruction> instructions_;
  std::size_t parameters_;
};

/// A program, or what is wrong with the text it was to be made of.
struct CompileResult {
  std::shared_ptr<const Program> program;  ///< null on failure
  std::string error;
  std::size_t at = 0;      ///< bytes of the text before the place of the error
  std::size_t length = 1;  ///< bytes to underline
};

}  // namespace firstlight::render
