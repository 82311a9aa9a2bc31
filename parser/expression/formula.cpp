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

void FormulaTable::go_to(const TokenFile& file) {
  const std::size_t index = file.source().index;
  if (index >= entries_.size()) entries_.resize(index + 1);
  if (entries_[index].empty()) entries_[index].resize(file.size());
  file_ = &file;
  of_file_ = entries_[index].data();
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
