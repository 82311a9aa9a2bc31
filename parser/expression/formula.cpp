#include "parser/expression/formula.h"

#include "parser/expression/formula_program.h"

#include <algorithm>
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

void FormulaTable::make_room(const TokenFile& file) {
  if (file.source().index >= entries_.size()) entries_.resize(file.source().index + 1);
  entries_[file.source().index].resize(file.size());
}

const Formula* FormulaTable::meet(const TokenFile& file, std::uint32_t begin, Formula::Kind kind,
                                  std::uint32_t& entry) {
  if (entry == kNew) {
    entry = kMet;
    return nullptr;
  }
  std::unique_ptr<const Formula> formula = Formula::compile(file, begin, kind);
  if (formula == nullptr) {
    entry = kNone;
    return nullptr;
  }
  formulas_.push_back(std::move(formula));
  entry = kFirst + static_cast<std::uint32_t>(formulas_.size() - 1);
  return formulas_.back().get();
}

}  // namespace firstlight::parser
