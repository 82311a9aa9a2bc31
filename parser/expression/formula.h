#pragma once

#include "parser/text/token.h"
#include "parser/text/token_file.h"
#include "parser/text/value.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

namespace firstlight::parser {

class FormulaProgram;

/// A numeric expression of the scene text in the form of steps for a stack machine: text that loops and macros replay
/// is analysed once and only evaluated from then on, by a program for each set of sizes that its names' values have.
///
/// Meaning  It stands for the expression as long as all its names are numbers or vectors when it is evaluated; whether
///          a name is a macro, say, can differ from turn to turn, so this is to be checked each time. Expressions with
///          calls of macros and functions, with elements of arrays, strings and the rarer functions have none. Warnings
///          and mistakes are those of parser/expression/expression.h, at the same places.
class Formula {
 public:
  /// How far an expression reaches: parse_sum() or parse_full_expression().
  enum class Kind : std::uint8_t { sum, full };
  static constexpr std::size_t kMostNames = 16;  // different ones
  static constexpr std::size_t kDeepestStack = 12;
  static constexpr std::size_t kDeepest = 32;  // parentheses, calls and signs in each other

  enum class Operation : std::uint8_t {
    number,
    name,
    unit,  ///< a vector such as `x`
    vector,
    add,
    subtract,
    multiply,
    divide,
    truth,  ///< comparisons, `&`, `|`
    negate,
    invert,
    component,
    promote,
    check_float,
    check_vector,
    call_number,  ///< the calls: by what the word is, see Word
    call_two,
    fold,
    fold_end,
    call_vectors,
  };
  /// How many components the place of an operand wants; other values are that number.
  static constexpr std::uint8_t kOfCaller = 0;  // as many as where the formula stands
  static constexpr std::uint8_t kOfLeft = 255;  // as many as the operand to the left has

  struct Step {
    Operation operation = Operation::number;
    std::uint8_t terms = 1;
    std::uint8_t index = 0;        ///< of a name among names(), a component; how many operands are taken
    const Token* token = nullptr;  ///< the word or sign; of a check the first token of what is checked
    double number = 0.0;
  };

  Formula();
  ~Formula();

  /// That of the expression which begins at `begin`; null when it has none.
  static std::unique_ptr<const Formula> compile(const TokenFile& file, std::uint32_t begin, Kind kind);

  /// Symbols of the names in it.
  std::span<const std::uint32_t> names() const { return names_; }
  /// Its reserved words, each as often as it stands there.
  std::span<const Keyword> keywords() const { return keywords_; }
  const Token& first() const { return tokens_.front(); }
  /// Index of the token behind it.
  std::uint32_t end() const { return end_; }
  /// Levels of nesting it takes, at most.
  std::size_t depth() const { return depth_; }
  /// The text behind it might go on with it, were it a macro or directive, so that nothing may be obeyed there.
  bool ends_at_hold() const { return ends_at_hold_; }

  /// Whether it is a name and nothing else.
  bool is_name() const { return steps_.size() == 1 && steps_[0].operation == Operation::name; }

  /// Shape of the values of the names, kShapeBits each: how many components, and kColorShape of a colour.
  using Shape = std::uint64_t;
  static constexpr unsigned kShapeBits = 4, kColorShape = 8;
  static_assert(kMostNames * kShapeBits <= 64);
  static Shape shape_of(const Numbers& value, std::size_t name) {
    return Shape{value.size | (value.is_color ? kColorShape : 0u)} << (kShapeBits * name);
  }

  /// The program for values of `shape`, where the place wants `terms` components. Null when an operand has a size that
  /// its place does not take, which is a mistake in the scene, and when there are too many programs already: then the
  /// expression is to be read token by token.
  const FormulaProgram* program(Shape shape, std::uint8_t terms) const {
    return shape == latest_shape_ && terms == latest_terms_ ? latest_ : other_program(shape, terms);
  }

 private:
  friend class FormulaCompiler;
  static constexpr std::size_t kMostPrograms = 8;

  const FormulaProgram* other_program(Shape shape, std::uint8_t terms) const;

  std::deque<Token> tokens_;  // its own, for the file may give up the page; a deque, for steps point into it
  std::vector<Step> steps_;
  std::vector<std::uint32_t> names_;
  std::vector<Keyword> keywords_;
  std::uint32_t end_ = 0;
  std::size_t depth_ = 0;
  bool ends_at_hold_ = false;
  // For the shapes that there have been, and for the one that came last.
  mutable std::vector<std::unique_ptr<const FormulaProgram>> programs_;
  mutable const FormulaProgram* latest_ = nullptr;
  mutable Shape latest_shape_ = 0;
  mutable std::uint8_t latest_terms_ = 0;  // 0: none has come
};

/// The formulas of a scene's expressions. One is made when an expression is met for the second time.
class FormulaTable {
 public:
  /// That of the expression which begins at the token `begin`; null when it is met for the first time or has none.
  const Formula* find(const TokenFile& file, std::uint32_t begin, Formula::Kind kind) {
    if (&file != file_) go_to(file);
    std::uint32_t& entry = of_file_[begin][static_cast<std::size_t>(kind)];
    return entry >= kFirst  ? formulas_[entry - kFirst].get()
           : entry == kNone ? nullptr
                            : meet(file, begin, kind, entry);
  }

 private:
  static constexpr std::uint32_t kNew = 0, kMet = 1, kNone = 2, kFirst = 3;

  using Entry = std::array<std::uint32_t, 2>;  // by kind

  void go_to(const TokenFile& file);
  const Formula* meet(const TokenFile& file, std::uint32_t begin, Formula::Kind kind, std::uint32_t& entry);

  std::vector<std::vector<Entry>> entries_;  // by SourceFile::index, and first token
  const TokenFile* file_ = nullptr;          // of the latest question
  Entry* of_file_ = nullptr;                 // its entries
  std::vector<std::unique_ptr<const Formula>> formulas_;
};

}  // namespace firstlight::parser
