#pragma once

#include "parser/expression/formula.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace firstlight::parser {

class Evaluator;
struct Word;

/// A formula for names that stand for values of known sizes. Then the sizes of all operands are known, so they lie side
/// by side on a stack of plain numbers, and a vector written in the text is there as soon as its components are.
class FormulaProgram {
 public:
  /// Null when some operand has a size that its place does not take, which is a mistake in the scene.
  static std::unique_ptr<const FormulaProgram> make(std::span<const Formula::Step> steps, Formula::Shape shape,
                                                    std::uint8_t terms);

  bool serves(Formula::Shape shape, std::uint8_t terms) const { return shape == shape_ && terms == terms_; }
  /// Pre: the values are of the shape that it serves; `result` is as it was made.
  void run(Evaluator& in, const Numbers* const* values, Numbers& result) const;

 private:
  friend class FormulaSizer;

  enum class Operation : std::uint8_t {
    number,
    name,
    wide_name,
    unit,
    promote,  ///< from `left` to `size` components
    // operations on two single numbers
    add,
    subtract,
    multiply,
    divide,
    truth,
    combine,  ///< any of the above, of `left` and `size` components
    negate,
    invert,
    component,
    call_number,
    call_two,
    fold,
    fold_end,
    call_vectors,  ///< of `left` and `size` components
  };
  struct Step {
    Operation operation = Operation::number;
    std::uint8_t size = 1;  ///< of the operand on top
    std::uint8_t left = 1;  ///< of the one below it
    std::uint8_t index = 0;
    Formula::Operation of_two = Formula::Operation::add;  ///< what `combine` does
    const Token* token = nullptr;
    const Word* word = nullptr;  ///< the token's
    double number = 0.0;
  };

  static void combine(Evaluator& in, const Step& step, double*& top);
  static void call_vectors(Evaluator& in, const Step& step, double*& top);

  std::vector<Step> steps_;
  Formula::Shape shape_ = 0;
  std::uint8_t terms_ = 1;
  std::uint8_t size_ = 1;  // of the result
  bool is_color_ = false;
};

}  // namespace firstlight::parser
