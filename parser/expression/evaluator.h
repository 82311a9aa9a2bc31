#pragma once

#include "parser/expression/formula.h"
#include "parser/expression/random_streams.h"
#include "parser/text/language_state.h"
#include "parser/text/token_stream.h"
#include "render/feature/feature.h"
#include "render/function/function.h"
#include "render/scene/object_probe.h"
#include "render/scene/scene_builder.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace firstlight::parser {

/// The stream of tokens, with all that the value of an expression may rest on beside the text.
///
/// Errors   Throws SyntaxError.
class Evaluator : public TokenStream {
 public:
  static constexpr std::size_t kLongestString = 1u << 20;

  Evaluator(const render::LoadOptions& options, render::Diagnostics& diagnostics, render::SceneBuilder& builder)
      : TokenStream(options, diagnostics), builder_(builder) {}

  LanguageState& language() { return language_; }
  int language_version() const { return language_.version(); }
  int effective_language_version() const { return language_.effective_version(); }
  RandomStreams& random() { return random_; }

  // --- formulas -----------------------------------------------------------------------------------------------------
  /// The formula for the expression that is next, or that stands behind `opening` if it is named; null when there is
  /// none, or it cannot be used here, or what is behind it is not the `closing` that is named.
  const Formula* next_formula(Formula::Kind kind, Punctuation opening = Punctuation::none,
                              Punctuation closing = Punctuation::none);
  /// Takes the expression of what next_formula() has given, and the marks around it, and evaluates it. False when the
  /// formula does not hold now: then nothing is taken. `terms`: as for parse_sum(). Pre: `result` is as it was made.
  bool evaluate(const Formula& formula, std::uint8_t terms, Numbers& result, Punctuation closing = Punctuation::none);

  // --- questions about what is declared -----------------------------------------------------------------------------
  /// The value of a function at parse time; `name` is where it is called.
  Numbers evaluate(const render::Function& function, const double* arguments, const Token& name);
  /// The geometry of a declared object, kept for the next question about it.
  const render::ObjectProbe& probe(const std::shared_ptr<const render::Object>& object);
  bool file_exists(const std::string& name) const;
  /// `(name)` behind `defined` or `#ifdef`: whether it is declared; of an array's element, whether it has a value.
  bool parse_defined();

 protected:
  ~Evaluator() = default;

 private:
  render::SceneBuilder& builder_;
  LanguageState language_;
  RandomStreams random_;
  FormulaTable formulas_;
  std::vector<std::pair<std::shared_ptr<const render::Object>, render::ObjectProbe>> probes_;  // the latest last
};

}  // namespace firstlight::parser
