#pragma once

#include "render/function/program.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace firstlight::parser {

/// The instructions of a function under construction. What depends on constants only is a constant at once; a constant
/// on the right of an operator becomes part of the instruction where POV-Ray does so, for that rounds differently:
/// x / 3 is x * (1 / 3) there, and pow(x, 3) is x * x * x.
class Emitter {
 public:
  using Operation = render::Operation;

  void constant(double value) { push({Operation::constant, 0, 0, value}); }
  void parameter(std::size_t index) { push({Operation::parameter, 0, static_cast<std::uint16_t>(index), 0.0}); }
  void local(std::size_t place) { push({Operation::local, 0, static_cast<std::uint16_t>(place), 0.0}); }
  void apply(Operation operation);
  /// The operation with `right` as its right operand.
  void apply_constant(Operation operation, double right);
  void call(render::FunctionPtr callee, std::uint8_t component);
  /// Takes first and last of a loop; returns where it begins, for end_loop().
  std::size_t begin_loop(double neutral);
  void end_loop(std::size_t begin, Operation operation);

  /// The number of instructions so far; marks a place for the two below.
  std::size_t mark() const { return instructions_.size(); }
  /// Takes back what was pushed since `mark`, if it is one constant and nothing else.
  std::optional<double> take_constant(std::size_t mark);
  /// Takes back what was emitted since `mark`, which left the stack as it was.
  void return_to(std::size_t mark) { instructions_.resize(mark); }
  /// Puts a constant in the place of the one value that was pushed since `mark`.
  void replace_since(std::size_t mark, double value);
  /// Whether something since `mark` depends on a parameter or a loop's variable.
  bool varies_since(std::size_t mark) const;

  /// Values on the stack.
  std::size_t height() const { return height_; }
  bool fits() const;
  /// Whether it can be called without endless work.
  bool is_affordable() const;
  std::shared_ptr<const render::Program> finish(std::size_t parameters);

 private:
  void push(const render::Instruction& instruction);

  std::vector<render::Instruction> instructions_;
  std::vector<render::FunctionPtr> callees_;
  std::size_t height_ = 0;
  std::size_t highest_ = 0;
};

}  // namespace firstlight::parser
