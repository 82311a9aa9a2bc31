#pragma once

#include "render/function/function.h"
#include "render/function/instruction.h"
#include "render/function/row_program.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace firstlight::render {

/// A function of some numbers as instructions of a stack machine, for one point or for many at a time.
///
/// Source   The meaning of each operation is that of POV-Ray 3.7's functions: whatever is not 0 is true, comparisons
///          are exact. What has no value is not-a-number or infinite, never an error.
/// Cost     one to three nanoseconds an instruction; with many points, a tenth of it an instruction and point.
/// Threads  Immutable.
class Program final : public Function {
 public:
  static constexpr std::size_t kMostInstructions = 65535;
  static constexpr std::size_t kDeepest = 64;  ///< values on the stack

  /// Pre: the instructions leave one value, never take from an empty stack nor exceed kDeepest; parameters and callees
  /// exist; Function's limits hold.
  Program(std::vector<Instruction> instructions, std::size_t parameters, std::vector<FunctionPtr> callees = {});

  std::span<const Instruction> instructions() const { return instructions_; }
  std::span<const FunctionPtr> callees() const { return callees_; }
  /// Whether many points are worked on side by side.
  bool is_in_rows() const { return in_rows_; }
  void evaluate(const double* arguments, double* results, Evaluation& evaluation) const override;
  /// Pre: as many arguments as parameters.
  double evaluate(std::span<const double> arguments) const;
  /// results[i] = value at arguments[p][i] for parameter p. Pre: as many columns as parameters, each as long as
  /// results, or empty if no instruction asks for it.
  void evaluate(std::span<const std::span<const double>> arguments, std::span<double> results) const;
  void evaluate_many(const double* const* arguments, double* const* results, std::size_t count,
                     Evaluation& evaluation) const override;

 private:
  std::vector<Instruction> instructions_;
  std::vector<FunctionPtr> callees_;
  bool in_rows_;
  RowProgram rows_;
};

/// A program, or what is wrong with the text it was to be made of.
struct CompileResult {
  std::shared_ptr<const Program> program;  ///< null on failure
  std::string error;
  std::size_t at = 0;      ///< bytes of the text before the place of the error
  std::size_t length = 1;  ///< bytes to underline
};

/// About how many instructions a call of a program of these instructions takes, and how deep its calls go.
struct ProgramSize {
  std::uint64_t cost = 0;
  std::uint32_t depth = 0;
};
ProgramSize size_of(std::span<const Instruction> instructions, std::span<const FunctionPtr> callees);

}  // namespace firstlight::render
