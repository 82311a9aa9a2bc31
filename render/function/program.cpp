#include "render/function/program.h"

#include "render/function/elementary.h"
#include "render/function/operations.h"

#include <algorithm>
#include <array>
#include <utility>

namespace firstlight::render {
namespace {

/// Points at a time: enough to make an instruction's dispatch cheap, few enough to keep the stack in the cache.
constexpr std::size_t kPointsAtOnce = 32;
using Row = std::array<double, kPointsAtOnce>;

/// Rows of all programs that call each other stand on the machine's stack.
constexpr std::uint32_t kDeepestInRows = 40;

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

/// Mixes red, green and blue with the weights of POV-Ray's grey scale, added in its order.
double mixed(double red, double green, double blue, std::uint8_t component) {
  if (component == kGrayComponent) return red * 0.297 + green * 0.589 + blue * 0.114;
  return (red + green * (1.0 / 255.0)) * 0.996093;  // kHeightComponent
}

double component_of(const double* results, std::uint8_t component) {
  if (component < Function::kMostResults) return results[component];
  return mixed(results[0], results[1], results[2], component);
}

/// The values of one evaluation, and the place in the program.
struct Machine {
  std::array<double, Program::kDeepest + 1> values;
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

/// `values`: the rows of the arguments, the first of which becomes the result's.
void call_in_rows(const Function& callee, std::uint8_t component, Row* values, std::size_t count,
                  Evaluation& evaluation) {
  std::array<const double*, Function::kMostParameters> arguments;
  for (std::size_t p = 0; p < callee.parameter_count(); ++p) arguments[p] = values[p].data();
  std::array<Row, Function::kMostResults> rows;
  std::array<double*, Function::kMostResults> results;
  for (std::size_t r = 0; r < rows.size(); ++r) results[r] = rows[r].data();
  callee.evaluate_many(arguments.data(), results.data(), count, evaluation);
  if (component < Function::kMostResults) {
    std::copy_n(rows[component].begin(), count, values[0].begin());
    return;
  }
  for (std::size_t i = 0; i < count; ++i) values[0][i] = mixed(rows[0][i], rows[1][i], rows[2][i], component);
}

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
      in_rows_(!has_loops(instructions_) && depth() <= kDeepestInRows) {}

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
      case Operation::select_negative:
        m.top -= 2;
        m.top[-1] = render::select_negative(m.top[-1], m.top[0], m.top[1]);
        break;
      case Operation::select:
        m.top -= 3;
        m.top[-1] = render::select(m.top[-1], m.top[0], m.top[1], m.top[2]);
        break;
      default:
        if (instruction.operation < Operation::add) {
          with_one(instruction, [&](auto f) { m.top[-1] = f(m.top[-1]); });
        } else {
          --m.top;
          with_two(instruction.operation, [&](auto f) { m.top[-1] = f(m.top[-1], m.top[0]); });
        }
        break;
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
  std::array<Row, kDeepest> stack;
  for (std::size_t begin = 0; begin < points; begin += kPointsAtOnce) {
    const std::size_t count = std::min(kPointsAtOnce, points - begin);
    std::size_t size = 0;
    for (const Instruction& instruction : instructions_) {
      switch (instruction.operation) {
        case Operation::constant:
          std::fill_n(stack[size++].begin(), count, instruction.value);
          continue;
        case Operation::parameter:
          std::copy_n(arguments[instruction.index] + begin, count, stack[size++].begin());
          continue;
        case Operation::local:
          std::copy_n(stack[instruction.index].begin(), count, stack[size++].begin());
          continue;
        case Operation::call: {
          const Function& callee = *callees_[instruction.index];
          size -= callee.parameter_count();
          call_in_rows(callee, instruction.component, &stack[size], count, evaluation);
          ++size;
          continue;
        }
        default:
          break;
      }
      const auto taken = static_cast<std::size_t>(operands(instruction.operation));
      size -= taken - 1;
      Row& a = stack[size - 1];
      const Row* further = &stack[size];
      const auto each = [&](auto value) {
        for (std::size_t i = 0; i < count; ++i) a[i] = value(i);
      };
      if (evaluate_elementary(instruction.operation, a.data(), further->data(), count)) continue;
      if (taken == 1) {
        with_one(instruction, [&](auto f) { each([&](std::size_t i) { return f(a[i]); }); });
      } else if (taken == 2) {
        with_two(instruction.operation, [&](auto f) { each([&](std::size_t i) { return f(a[i], further[0][i]); }); });
      } else if (taken == 3) {
        each([&](std::size_t i) { return render::select_negative(a[i], further[0][i], further[1][i]); });
      } else {
        each([&](std::size_t i) { return render::select(a[i], further[0][i], further[1][i], further[2][i]); });
      }
    }
    std::copy_n(stack[0].begin(), count, results[0] + begin);
  }
}

}  // namespace firstlight::render
