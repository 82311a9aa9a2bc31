#pragma once

#include "parser/text/token.h"
#include "parser/text/value.h"
#include "render/function/instruction.h"
#include "render/math/vec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace firstlight::parser {

class Evaluator;

/// Kinds of what a word begins in an expression.
enum class WordKind : std::uint8_t { other, number, vector, color, string };

/// A word that may stand in an expression: a row of the table in words.cpp. All that reads expressions asks it: the text
/// itself, formulas for text that is replayed, the bodies of functions.
///
/// Source   [POV-Ray 3.7 manual, "Float Expressions", "Vector Expressions", "String Expressions"]
struct Word {
  // How its value comes about. `word` is the word in the text, where mistakes are told of.

  /// A number whatever the scene says.
  struct Constant {
    double value;
  };
  /// A vector of `size` components, of which one is 1.
  struct Unit {
    std::uint8_t component, size;
  };
  /// `word(number)`; a full expression.
  using OfOne = double (*)(Evaluator& in, const Token& word, double);
  /// `word(number, number)`
  using OfTwo = double (*)(Evaluator& in, const Token& word, double, double);
  /// `word(number, number ...)`: one or more, taken in one after the other.
  struct Fold {
    double (*join)(double so_far, double next);
    bool is_whole;  ///< the result is a whole number, of a single one too
  };
  /// `word(vector)`, `word(vector, vector)` or `word(vector, vector, degrees)`
  struct OfVectors {
    render::Vec3 (*value)(Evaluator& in, const Token& word, const render::Vec3&, const render::Vec3&, double degrees);
    bool takes_second;
    bool takes_degrees;
  };
  /// The function reads what stands behind the word itself.
  using Reader = Numbers (*)(Evaluator& in, const Token& word);
  /// The same of strings, between the parentheses.
  using StringReader = std::string (*)(Evaluator& in, const Token& word);

  Keyword keyword = Keyword::none;
  WordKind kind = WordKind::other;
  std::variant<std::monostate, Constant, Unit, OfOne, OfTwo, Fold, OfVectors, Reader, StringReader> value;
  /// Its instruction in the body of a function, if that is one.
  std::optional<render::Operation> operation;
};

/// The row of a word; of one that is in no expression a row of kind `other`.
const Word& word_of(Keyword word);
inline WordKind word_kind(Keyword word) { return word_of(word).kind; }

/// The value of a fold of numbers at its end.
double fold_end(const Word::Fold& fold, double so_far);

}  // namespace firstlight::parser
