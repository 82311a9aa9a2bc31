#include "render/function/program.h"

#include "render/function/operations.h"

#include <algorithm>
#include <array>
#include <utility>

namespace firstlight::render {
namespace {

/// Points at a time: enough to make an instruction's dispatch cheap, few enough to keep the stack in the cache.
constexpr std::size_t kPointsAtOnce = 32;
using Row = std::array<double, kPointsAtOnce>;

bool is_flat(std::span<const Instruction> instructions) {
  return std::none_of(instructions.begin(), instructions.end(), [](const Instruction& i) {
    return i.operation >= Operation::local && i.operation <= Operation::end_product;
  });
}

FeatureUses unrendered_of(std::span<const FunctionPtr> callees) {
  FeatureUses all;
  for (const FunctionPtr& callee : callees) all.add(callee->unrendered());
  return all;
}

double component_of(const double* results, std::uint8_t component) {
  // The weights of POV-Ray's grey scale, added in its order.
  if (component == kGrayComponent) return results[0] * 0.297 + results[1] * 0.589 + results[2] * 0.114;
  if (component == kHeightComponent) return (results[0] + results[1] * (1.0 / 255.0)) * 0.996093;
  return results[component];
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
      flat_(is_flat(instructions_)) {}

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

void Program::evaluate_one_by_one(std::span<const std::span<const double>> arguments, std::span<double> results) const {
  std::vector<double> point(arguments.size());
  Evaluation evaluation;
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (std::size_t p = 0; p < arguments.size(); ++p) point[p] = i < arguments[p].size() ? arguments[p][i] : 0.0;
    evaluate(point.data(), &results[i], evaluation);
  }
}

void Program::evaluate(std::span<const std::span<const double>> arguments, std::span<double> results) const {
  if (!flat_) return evaluate_one_by_one(arguments, results);
  std::array<Row, kDeepest> stack;
  for (std::size_t begin = 0; begin < results.size(); begin += kPointsAtOnce) {
    const std::size_t count = std::min(kPointsAtOnce, results.size() - begin);
    std::size_t size = 0;
    for (const Instruction& instruction : instructions_) {
      const auto taken = static_cast<std::size_t>(operands(instruction.operation));
      if (taken == 0) {
        Row& row = stack[size++];
        if (instruction.operation == Operation::constant) {
          std::fill_n(row.begin(), count, instruction.value);
        } else {
          std::copy_n(arguments[instruction.index].begin() + static_cast<std::ptrdiff_t>(begin), count, row.begin());
        }
        continue;
      }
      size -= taken - 1;
      Row& a = stack[size - 1];
      const Row* further = &stack[size];
      const auto each = [&](auto value) {
        for (std::size_t i = 0; i < count; ++i) a[i] = value(i);
      };
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
    std::copy_n(stack[0].begin(), count, results.begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

}  // namespace firstlight::render
