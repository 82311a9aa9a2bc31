#include "parser/expression/formula.h"

#include "parser/directive/interpreter.h"
#include "parser/expression/formula_program.h"

#include <algorithm>
#include <array>
#include <utility>

namespace firstlight::parser {

Formula::Formula() = default;
Formula::~Formula() = default;

const FormulaProgram* Formula::other_program(Shape shape, std::uint8_t terms) const {
  auto found = std::ranges::find_if(programs_, [&](const auto& program) { return program->serves(shape, terms); });
  if (found == programs_.end()) {
    if (programs_.size() == kMostPrograms) return nullptr;
    std::unique_ptr<const FormulaProgram> made = FormulaProgram::make(steps_, shape, terms);
    if (made == nullptr) return nullptr;
    found = programs_.insert(found, std::move(made));
  }
  latest_shape_ = shape;
  latest_terms_ = terms;
  return latest_ = found->get();
}

const Formula* FormulaTable::meet(const TokenFile& file, std::uint32_t begin, Formula::Kind kind,
                                  std::uint32_t& entry) {
  if (entry == kNew) {
    entry = kMet;
    return nullptr;
  }
  std::unique_ptr<const Formula> formula = Formula::compile(file.tokens, begin, kind);
  if (formula == nullptr) {
    entry = kNone;
    return nullptr;
  }
  formulas_.push_back(std::move(formula));
  entry = kFirst + static_cast<std::uint32_t>(formulas_.size() - 1);
  return formulas_.back().get();
}

const Formula* Interpreter::next_formula(Formula::Kind kind, Punctuation opening, Punctuation closing) {
  Text text = replayed_text();
  if (text.file == nullptr) return nullptr;
  const std::vector<Token>& tokens = text.file->tokens;
  if (opening != Punctuation::none && !tokens[text.begin++].is(opening)) return nullptr;
  if (text.begin >= text.end) return nullptr;
  const Formula* const formula = formulas_.find(*text.file, text.begin, kind);
  if (formula == nullptr || formula->end() >= text.end) return nullptr;
  const bool ends_here =
      closing != Punctuation::none ? tokens[formula->end()].is(closing) : !formula->ends_at_hold() || is_held();
  return ends_here && may_nest(formula->depth()) ? formula : nullptr;
}

bool Interpreter::evaluate(const Formula& formula, std::uint8_t terms, Numbers& result, Punctuation closing) {
  std::array<const Numbers*, Formula::kMostNames> values;
  Formula::Shape shape = 0;
  std::size_t name = 0;
  for (const std::uint32_t symbol : formula.names()) {
    const Scopes::Binding* const binding = scopes_.find(symbol);
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

}  // namespace firstlight::parser
