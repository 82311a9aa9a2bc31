#include "render/function/program.h"

#include "render/function/operations-inl.h"

#include <algorithm>
#include <array>
#include <utility>

namespace firstlight::render {
namespace {

/// Rows of all programs that call each other stand on the machine's stack.
constexpr std::uint32_t kDeepestInRows = 20;

bool has_loops(std::span<const Instruction> instructions) {
  return std::any_of(instructions.begin(), instructions.end(), [](const Instruction& i) {
    return i.operation >= Operation::loop && i.operation <= Operation::end_product;
  });
}

FeatureUses unrendered_of(std::span<const FunctionPtr> callees) {
  FeatureUses all;
  for (const FunctionPtr& callee : callees) all.add(callee->unrendered());
  return all;
}

double component_of(const double* results, std::uint8_t component) {
  if (component == kGrayComponent) {
    return results[0] * kGrayWeights[0] + results[1] * kGrayWeights[1] + results[2] * kGrayWeights[2];
  }
  if (component == kHeightComponent) return (results[0] + results[1] * kHeightWeights[1]) * kHeightWeights[0];
  return results[component];
}

/// The values of one evaluation, and the place in the program.
struct Machine {
  std::array<double, Program::kDeepest + 4> values;
  double* top = values.data();  ///< behind the last value
  std::size_t next = 0;         ///< instruction

  void call(const Instruction& instruction, const Function& callee, Evaluation& evaluation) {
    std::array<double, Function::kMostResults> results;
    top -= callee.parameter_count();
    callee.evaluate(top, results.data(), evaluation);
    *top++ = component_of(results.data(), instruction.component);
  }
  // first, last -> variable, last, result so far
  void begin_loop(const Instruction& instruction) {
    *top++ = instruction.value;
    if (top[-3] <= top[-2]) return;
    top[-3] = instruction.value;
    top -= 2;
    next = instruction.index;
  }
  void end_turn(const Instruction& instruction, std::size_t self, Evaluation& evaluation) {
    const double value = *--top;
    top[-1] = instruction.operation == Operation::end_sum ? top[-1] + value : top[-1] * value;
    top[-3] += 1.0;
    const std::uint64_t steps =
        std::min<std::uint64_t>(static_cast<std::uint64_t>(instruction.value), evaluation.steps_left);
    evaluation.steps_left -= steps;
    if (top[-3] <= top[-2] && evaluation.steps_left > 0) {
      next = instruction.index;
      return;
    }
    top[-3] = top[-1];
    top -= 2;
    next = self + 1;
  }
};

}  // namespace

ProgramSize size_of(std::span<const Instruction> instructions, std::span<const FunctionPtr> callees) {
  ProgramSize size{instructions.size(), 0};
  for (const Instruction& instruction : instructions) {
    if (instruction.operation != Operation::call) continue;
    const Function& callee = *callees[instruction.index];
    size.cost += callee.cost();
    size.depth = std::max(size.depth, callee.depth() + 1);
  }
  return size;
}

Program::Program(std::vector<Instruction> instructions, std::size_t parameters, std::vector<FunctionPtr> callees)
    : Function(parameters, 1, size_of(instructions, callees).cost, size_of(instructions, callees).depth,
               unrendered_of(callees)),
      instructions_(std::move(instructions)),
      callees_(std::move(callees)),
      in_rows_(!has_loops(instructions_) && depth() <= kDeepestInRows) {
  if (in_rows_) rows_ = RowProgram(instructions_, parameters, callees_);
}

void Program::evaluate(const double* arguments, double* results, Evaluation& evaluation) const {
  Machine m;
  const std::size_t count = instructions_.size();
  while (m.next < count) {
    const std::size_t self = m.next++;
    const Instruction& instruction = instructions_[self];
    switch (instruction.operation) {
      case Operation::constant:
        *m.top++ = instruction.value;
        break;
      case Operation::parameter:
        *m.top++ = arguments[instruction.index];
        break;
      case Operation::local:
        *m.top++ = m.values[instruction.index];
        break;
      case Operation::call:
        m.call(instruction, *callees_[instruction.index], evaluation);
        break;
      case Operation::loop:
        m.begin_loop(instruction);
        break;
      case Operation::end_sum:
      case Operation::end_product:
        m.end_turn(instruction, self, evaluation);
        break;
      default: {
        m.top -= operands(instruction.operation);
        const double* const from[] = {m.top, m.top + 1, m.top + 2, m.top + 3};
        HWY_NAMESPACE::operate<One>(instruction, from, m.top++, 1);
        break;
      }
    }
  }
  *results = m.values[0];
}

double Program::evaluate(std::span<const double> arguments) const {
  Evaluation evaluation;
  double result = 0.0;
  evaluate(arguments.data(), &result, evaluation);
  return result;
}

void Program::evaluate(std::span<const std::span<const double>> arguments, std::span<double> results) const {
  std::array<const double*, kMostParameters> columns;
  for (std::size_t p = 0; p < arguments.size(); ++p) columns[p] = arguments[p].data();
  double* const result = results.data();
  Evaluation evaluation;
  evaluate_many(columns.data(), &result, results.size(), evaluation);
}

void Program::evaluate_many(const double* const* arguments, double* const* results, std::size_t points,
                            Evaluation& evaluation) const {
  if (!in_rows_) return Function::evaluate_many(arguments, results, points, evaluation);
  rows_.evaluate(arguments, results[0], points, evaluation);
}

}  // namespace firstlight::render
