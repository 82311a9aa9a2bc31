#include "parser/expression/function_emitter.h"

#include <algorithm>
#include <array>
#include <utility>

namespace firstlight::parser {

using render::Function;
using render::Instruction;
using render::Operation;
using render::Program;

void Emitter::push(const Instruction& instruction) {
  instructions_.push_back(instruction);
  highest_ = std::max(highest_, ++height_);
}

void Emitter::apply(Operation operation) {
  const auto taken = static_cast<std::size_t>(render::operands(operation));
  const Instruction instruction{operation, 0, 0, 0.0};
  const auto first = instructions_.end() - static_cast<std::ptrdiff_t>(taken);
  const bool known =
      std::all_of(first, instructions_.end(), [](const Instruction& i) { return i.operation == Operation::constant; });
  height_ -= taken - 1;
  if (!known) {
    instructions_.push_back(instruction);
    return;
  }
  std::array<double, 4> values{};
  std::transform(first, instructions_.end(), values.begin(), [](const Instruction& i) { return i.value; });
  instructions_.erase(first, instructions_.end());
  instructions_.push_back({Operation::constant, 0, 0, render::apply(instruction, values.data())});
}

void Emitter::apply_constant(Operation operation, double right) {
  switch (operation) {
    case Operation::subtract:
      right = -right;
      [[fallthrough]];
    case Operation::add:
      if (right != 0.0) instructions_.push_back({Operation::add_constant, 0, 0, right});
      return;
    case Operation::divide:
      right = 1.0 / right;
      [[fallthrough]];
    case Operation::multiply:
      if (right != 1.0) instructions_.push_back({Operation::multiply_constant, 0, 0, right});
      return;
    case Operation::power:
      if (right >= 2.0 && right <= 8.0 && right == static_cast<int>(right)) {
        instructions_.push_back({Operation::whole_power, 0, static_cast<std::uint16_t>(right), 0.0});
        return;
      }
      [[fallthrough]];
    default:
      constant(right);
      apply(operation);
      return;
  }
}

void Emitter::call(render::FunctionPtr callee, std::uint8_t component) {
  const auto found = std::find(callees_.begin(), callees_.end(), callee);
  const auto index = static_cast<std::uint16_t>(found - callees_.begin());
  height_ -= callee->parameter_count() - 1;
  highest_ = std::max(highest_, height_);
  if (found == callees_.end()) callees_.push_back(std::move(callee));
  instructions_.push_back({Operation::call, component, index, 0.0});
}

std::size_t Emitter::begin_loop(double neutral) {
  push({Operation::loop, 0, 0, neutral});
  return instructions_.size();
}

void Emitter::end_loop(std::size_t begin, Operation operation) {
  const auto body = std::span<const Instruction>(instructions_).subspan(begin);
  const auto cost = static_cast<double>(size_of(body, callees_).cost + 1);
  instructions_.push_back({operation, 0, static_cast<std::uint16_t>(begin), cost});
  instructions_[begin - 1].index = static_cast<std::uint16_t>(instructions_.size());
  height_ -= 3;
}

std::optional<double> Emitter::take_constant(std::size_t mark) {
  if (instructions_.size() != mark + 1 || instructions_.back().operation != Operation::constant) return std::nullopt;
  const double value = instructions_.back().value;
  instructions_.pop_back();
  --height_;
  return value;
}

void Emitter::replace_since(std::size_t mark, double value) {
  return_to(mark);
  --height_;
  constant(value);
}

bool Emitter::varies_since(std::size_t mark) const {
  return std::any_of(
      instructions_.begin() + static_cast<std::ptrdiff_t>(mark), instructions_.end(),
      [](const Instruction& i) { return i.operation == Operation::parameter || i.operation == Operation::local; });
}

bool Emitter::fits() const {
  return instructions_.size() < Program::kMostInstructions && highest_ <= Program::kDeepest;
}

bool Emitter::is_affordable() const {
  const render::ProgramSize size = size_of(instructions_, callees_);
  return size.cost <= Function::kMostCost && size.depth <= Function::kDeepestCalls;
}

std::shared_ptr<const Program> Emitter::finish(std::size_t parameters) {
  return std::make_shared<const Program>(std::move(instructions_), parameters, std::move(callees_));
}

}  // namespace firstlight::parser
