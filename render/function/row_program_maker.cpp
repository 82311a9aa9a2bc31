// How instructions of a stack become steps between rows: values are numbered, those that are the same only once; then
// each gets a row for as long as it is needed.
#include "render/function/program.h"
#include "render/function/row_program.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace firstlight::render {
namespace {

/// Instructions of callees that may become part of a program.
constexpr std::size_t kMostInlined = 3000;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A parameter, a constant, what an operation gives, a call, or the result Instruction::component of one.
struct Value {
  Instruction instruction;
  const Function* callee = nullptr;     ///< of a call
  std::vector<std::uint32_t> operands;  ///< numbers of values; of a result, its call's
  bool is_result = false;
};

auto key_of(const Value& v) {
  return std::tuple(v.instruction.operation, v.instruction.component, v.instruction.index,
                    std::bit_cast<std::uint64_t>(v.instruction.value), v.callee, v.is_result, v.operands);
}

}  // namespace

class RowProgram::Maker {
 public:
  /// `is_shared`: whether values that are the same are one, and callees become part of the program.
  explicit Maker(bool is_shared) : is_shared_(is_shared) {}

  /// Adds values; the number of the last.
  std::uint32_t add(std::span<const Instruction> instructions, std::span<const std::uint32_t> arguments,
                    std::span<const FunctionPtr> callees) {
    std::vector<std::uint32_t> stack;
    for (const Instruction& instruction : instructions) {
      std::uint32_t value = 0;
      std::size_t taken = 0;
      if (instruction.operation == Operation::parameter) {
        value = arguments[instruction.index];
      } else if (instruction.operation == Operation::local) {
        value = stack[instruction.index];
      } else if (instruction.operation == Operation::call) {
        const Function& callee = *callees[instruction.index];
        taken = callee.parameter_count();
        value = add_call(callee, instruction.component, std::span(stack).last(taken));
      } else {
        taken = static_cast<std::size_t>(operands(instruction.operation));
        value = add({instruction, nullptr, {stack.end() - static_cast<std::ptrdiff_t>(taken), stack.end()}});
      }
      stack.resize(stack.size() - taken);
      stack.push_back(value);
    }
    return stack.back();
  }
  std::uint32_t add_parameter(std::uint16_t index) { return add({{Operation::parameter, 0, index, 0.0}, nullptr, {}}); }

  /// False if there are not enough rows.
  bool make(std::uint32_t result, std::size_t parameters, RowProgram& program) {
    find_needs(result);
    program.parameters_ = parameters;
    std::vector<std::uint32_t> row(values_.size(), kNone);
    for (std::uint32_t i = 0; i < values_.size(); ++i) {
      const Instruction& instruction = values_[i].instruction;
      if (last_use_[i] == kNone) continue;
      if (instruction.operation == Operation::parameter) row[i] = instruction.index;
      if (instruction.operation != Operation::constant || program.constants_.size() == kMostConstants) continue;
      row[i] = static_cast<std::uint32_t>(parameters + program.constants_.size());
      program.constants_.emplace_back().at.fill(instruction.value);
    }
    first_own_ = static_cast<std::uint32_t>(parameters + program.constants_.size());
    for (std::uint32_t i = 0; i < values_.size(); ++i) {
      if (last_use_[i] != kNone && row[i] == kNone) add_step(i, row, program);
    }
    program.result_ = row[result];
    program.rows_ = rows_;
    return rows_ <= kMostRows;
  }

 private:
  std::uint32_t add(Value value) {
    const auto number = static_cast<std::uint32_t>(values_.size());
    if (is_shared_) {
      const auto [found, is_new] = numbers_.try_emplace(key_of(value), number);
      if (!is_new) return found->second;
    }
    values_.push_back(std::move(value));
    return number;
  }
  std::uint32_t add_call(const Function& callee, std::uint8_t component, std::span<const std::uint32_t> arguments) {
    if (const auto* program = is_shared_ ? dynamic_cast<const Program*>(&callee) : nullptr) {
      const std::size_t size = program->instructions().size();
      if (program->is_in_rows() && size <= inlined_left_) {
        inlined_left_ -= size;
        return add(program->instructions(), arguments, program->callees());
      }
    }
    const std::uint32_t call = add({{Operation::call, 0, 0, 0.0}, &callee, {arguments.begin(), arguments.end()}});
    const auto result = [&](std::uint8_t number) {
      return add({{Operation::call, number, 0, 0.0}, nullptr, {call}, true});
    };
    const auto times = [&](std::uint32_t value, double factor) {
      return add({{Operation::multiply_constant, 0, 0, factor}, nullptr, {value}});
    };
    const auto sum = [&](std::uint32_t a, std::uint32_t b) {
      return add({{Operation::add, 0, 0, 0.0}, nullptr, {a, b}});
    };
    if (component == kGrayComponent) {
      return sum(sum(times(result(0), kGrayWeights[0]), times(result(1), kGrayWeights[1])),
                 times(result(2), kGrayWeights[2]));
    }
    if (component == kHeightComponent) {
      return times(sum(result(0), times(result(1), kHeightWeights[1])), kHeightWeights[0]);
    }
    return result(component);
  }

  /// Finds where each value is used last; kNone: nowhere.
  void find_needs(std::uint32_t result) {
    last_use_.assign(values_.size(), kNone);
    asked_results_.assign(values_.size(), 0);
    last_use_[result] = kNone - 1;
    for (auto i = static_cast<std::uint32_t>(values_.size()); i-- > 0;) {
      if (last_use_[i] == kNone) continue;
      const Value& value = values_[i];
      for (const std::uint32_t operand : value.operands) {
        if (last_use_[operand] == kNone) last_use_[operand] = i;
      }
      if (value.is_result) asked_results_[value.operands[0]] |= 1u << value.instruction.component;
    }
  }
  std::uint32_t take_row() {
    if (free_.empty()) return first_own_ + rows_++;
    const std::uint32_t row = free_.back();
    free_.pop_back();
    return row;
  }
  void add_step(std::uint32_t number, std::vector<std::uint32_t>& row, RowProgram& program) {
    const Value& value = values_[number];
    if (value.is_result) {  // its call has given it a row
      row[number] = call_results_[value.operands[0]][value.instruction.component];
      return;
    }
    Step step{value.instruction, value.callee, {}, {}};
    if (value.callee == nullptr) {
      for (std::size_t k = 0; k < step.from.size(); ++k) {
        if (!value.operands.empty()) step.from[k] = row[value.operands[std::min(k, value.operands.size() - 1)]];
      }
      give_back(number, row);  // a step may write where it has read, but a call may not
      step.to[0] = row[number] = take_row();
    } else {
      step.from[0] = static_cast<std::uint32_t>(program.call_rows_.size());
      for (const std::uint32_t operand : value.operands) program.call_rows_.push_back(row[operand]);
      const std::size_t count = value.callee->result_count();
      auto& results = call_results_[number];
      for (std::size_t r = 0; r < count; ++r) step.to[r] = results[r] = take_row();
      for (std::size_t r = 0; r < count; ++r) {
        if ((asked_results_[number] >> r & 1u) == 0) free_.push_back(results[r]);
      }
      row[number] = results[0];
      give_back(number, row);
    }
    program.steps_.push_back(step);
  }
  /// Rows of values that the step `number` is the last to use.
  void give_back(std::uint32_t number, const std::vector<std::uint32_t>& row) {
    std::vector<std::uint32_t> operands = values_[number].operands;
    std::sort(operands.begin(), operands.end());
    operands.erase(std::unique(operands.begin(), operands.end()), operands.end());
    for (const std::uint32_t operand : operands) {
      if (last_use_[operand] == number && row[operand] >= first_own_) free_.push_back(row[operand]);
    }
  }

  bool is_shared_;
  std::size_t inlined_left_ = kMostInlined;
  std::vector<Value> values_;
  std::map<decltype(key_of(Value())), std::uint32_t> numbers_;
  std::vector<std::uint32_t> last_use_;
  std::vector<std::uint32_t> asked_results_;  ///< of calls: bits
  std::map<std::uint32_t, std::array<std::uint32_t, Function::kMostResults>> call_results_;
  std::vector<std::uint32_t> free_;
  std::uint32_t first_own_ = 0;
  std::uint32_t rows_ = 0;
};

RowProgram::RowProgram(std::span<const Instruction> instructions, std::size_t parameters,
                       std::span<const FunctionPtr> callees) {
  for (const bool is_shared : {true, false}) {
    *this = RowProgram();
    Maker maker(is_shared);
    std::vector<std::uint32_t> arguments;
    for (std::size_t p = 0; p < parameters; ++p) {
      arguments.push_back(maker.add_parameter(static_cast<std::uint16_t>(p)));
    }
    if (maker.make(maker.add(instructions, arguments, callees), parameters, *this)) return;
  }
}

}  // namespace firstlight::render
