#include "parser/expression/evaluator.h"

#include "parser/expression/formula_program.h"

#include <algorithm>
#include <array>

namespace firstlight::parser {

const Formula* Evaluator::next_formula(Formula::Kind kind, Punctuation opening, Punctuation closing) {
  Text text = replayed_text();
  if (text.file == nullptr) return nullptr;
  const TokenFile& tokens = *text.file;
  if (opening != Punctuation::none && !tokens.view(text.begin++).is(opening)) return nullptr;
  if (text.begin >= text.end) return nullptr;
  const Formula* const formula = formulas_.find(*text.file, text.begin, kind);
  if (formula == nullptr || formula->end() >= text.end) return nullptr;
  const bool ends_here =
      closing != Punctuation::none ? tokens.view(formula->end()).is(closing) : !formula->ends_at_hold() || is_held();
  return ends_here && may_nest(formula->depth()) ? formula : nullptr;
}

bool Evaluator::evaluate(const Formula& formula, std::uint8_t terms, Numbers& result, Punctuation closing) {
  std::array<const Numbers*, Formula::kMostNames> values;
  Formula::Shape shape = 0;
  std::size_t name = 0;
  for (const std::uint32_t symbol : formula.names()) {
    const Scopes::Binding* const binding = scopes().find(symbol);
    const Numbers* const value = binding != nullptr ? std::get_if<Numbers>(binding->slot.get()) : nullptr;
    if (value == nullptr) return false;
    shape |= Formula::shape_of(*value, name);
    values[name++] = value;
  }
  const FormulaProgram* const program = formula.program(shape, terms);
  if (program == nullptr) return false;
  take_to(formula.end() + (closing != Punctuation::none ? 1 : 0), formula.keywords());
  program->run(*this, values.data(), result);
  return true;
}

Numbers Evaluator::evaluate(const render::Function& function, const double* arguments, const Token& name) {
  render::Evaluation evaluation;
  evaluation.noise_generator = language_.noise_generator();
  Numbers result;
  result.size = static_cast<std::uint8_t>(function.result_count());
  function.evaluate(arguments, result.values.data(), evaluation);
  if (evaluation.steps_left == 0) {
    fail(name.location, "the loops in the function '" + std::string(name.text) + "' take too long");
  }
  // A value that cannot be known may have changed anything that follows.
  builder_.settings().unrendered.add(function.unrendered());
  return result;
}

const render::ObjectProbe& Evaluator::probe(const std::shared_ptr<const render::Object>& object) {
  constexpr std::size_t kKept = 8;
  const auto found = std::ranges::find_if(probes_, [&](const auto& kept) { return kept.first == object; });
  if (found != probes_.end()) {
    std::rotate(found, found + 1, probes_.end());
  } else {
    if (probes_.size() == kKept) probes_.erase(probes_.begin());
    probes_.emplace_back(object, render::ObjectProbe(*object));
  }
  return probes_.back().second;
}

bool Evaluator::file_exists(const std::string& name) const {
  return files().find_file(name, {}, frame().file->source()).status == SourceFiles::Status::found;
}

bool Evaluator::parse_defined() {
  expect(Punctuation::left_paren, "before the name");
  unsettle();
  const Scopes::Reach reach = take_reach();
  const Token name = take_prefixed(reach);
  if (name.kind != TokenKind::identifier && name.kind != TokenKind::keyword) {
    fail(name.location, "expected an identifier, found " + describe(name));
  }
  const Scopes::Binding* binding = name.kind == TokenKind::identifier ? scopes().find(name.symbol, reach) : nullptr;
  bool result = binding != nullptr;
  if (result && picks_part(*binding->slot, raw_next())) {
    const Scopes::Slot slot = binding->slot;
    result = !std::holds_alternative<std::monostate>(*pick_part(slot, name, Pick::test));
  }
  expect(Punctuation::right_paren, "behind the name");
  return result;
}

}  // namespace firstlight::parser
