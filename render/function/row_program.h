#pragma once

#include "render/function/function.h"
#include "render/function/instruction.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Instructions without loops, as steps from rows of numbers to rows: up to kPoints points at a time. What is worked
/// out twice is one step, and short programs that are called become part of the caller.
///
/// Memory   half a kilobyte for each of some different constants.
/// Threads  Immutable.
class RowProgram {
 public:
  /// Enough to make a step's dispatch cheap, few enough to keep the rows in the nearest cache.
  static constexpr std::size_t kPoints = 64;
  static constexpr std::size_t kMostRows = 80;        ///< of its own
  static constexpr std::size_t kMostConstants = 100;  ///< kept as rows; others are steps
  struct alignas(64) Row {
    std::array<double, kPoints> at;
  };
  /// An operation, or a call of the function `callee` with as many rows as it has parameters, its results.
  struct Step {
    Instruction instruction;
    const Function* callee = nullptr;
    std::array<std::uint32_t, 4> from{};  ///< numbers of rows; of a call, the first is a place in `call_rows`
    std::array<std::uint32_t, Function::kMostResults> to{};  ///< numbers of own rows
  };

  RowProgram() = default;
  /// Pre: as for Program; the callees live as long.
  RowProgram(std::span<const Instruction> instructions, std::size_t parameters, std::span<const FunctionPtr> callees);

  /// Arguments that no instruction asks for may be null. Pre: made with instructions.
  void evaluate(const double* const* arguments, double* results, std::size_t count, Evaluation& evaluation) const;

  // For those who run it. Rows are numbered: those of the parameters, the constants, then its own.
  std::size_t parameters() const { return parameters_; }
  std::span<const Row> constants() const { return constants_; }
  std::span<const Step> steps() const { return steps_; }
  std::span<const std::uint32_t> call_rows() const { return call_rows_; }
  std::size_t rows() const { return rows_; }
  std::uint32_t result() const { return result_; }

 private:
  class Maker;

  std::size_t parameters_ = 0;
  std::vector<Row> constants_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> call_rows_;
  std::size_t rows_ = 0;  ///< its own
  std::uint32_t result_ = 0;
};

}  // namespace firstlight::render
