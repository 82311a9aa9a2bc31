// From text to formulas, by the grammar of parser/expression/expression.cpp.
#include "parser/expression/arithmetic.h"
#include "parser/expression/formula.h"
#include "parser/expression/words.h"

#include <algorithm>
#include <variant>

namespace firstlight::parser {

/// One try to make a formula. Each function reads a part of the expression and gives false when it cannot be part of a
/// formula; then the try has failed. `terms` is what the place wants, as in Formula::Step.
class FormulaCompiler {
 public:
  using Operation = Formula::Operation;

  FormulaCompiler(const TokenFile& file, std::uint32_t begin, Formula& formula)
      : file_(file), begin_(begin), at_(begin), formula_(formula) {}

  bool compile(Formula::Kind kind) {
    if (!(kind == Formula::Kind::full ? full(Formula::kOfCaller) : sum(Formula::kOfCaller))) return false;
    const Token& behind = next();
    if (behind.is_end() || behind.is(Punctuation::period)) return false;
    formula_.ends_at_hold_ = behind.is(Punctuation::hash) || behind.kind == TokenKind::identifier;
    formula_.end_ = at_;
    for (std::uint32_t i = begin_; i < at_; ++i) {
      if (token(i).keyword != Keyword::none) formula_.keywords_.push_back(token(i).keyword);
    }
    return true;
  }

 private:
  /// One level of nesting; `fits()` is false beyond Formula::kDeepest.
  class Level {
   public:
    explicit Level(FormulaCompiler& compiler) : compiler_(compiler) {
      ++compiler_.depth_;
      compiler_.formula_.depth_ = std::max(compiler_.formula_.depth_, compiler_.depth_);
    }
    ~Level() { --compiler_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    bool fits() const { return compiler_.depth_ <= Formula::kDeepest; }

   private:
    FormulaCompiler& compiler_;
  };

  // They are copied into the formula as it comes to them.
  const Token& token(std::uint32_t index) {
    std::deque<Token>& tokens = formula_.tokens_;
    while (begin_ + tokens.size() <= index) tokens.push_back(file_[begin_ + tokens.size()]);
    return tokens[index - begin_];
  }
  const Token& next() { return token(at_); }
  const Token& take() { return token(at_++); }
  bool accept(Punctuation mark) {
    if (!next().is(mark)) return false;
    ++at_;
    return true;
  }

  Formula::Step& emit(Operation operation, const Token& token, std::uint8_t terms = 1) {
    Formula::Step step;
    step.operation = operation;
    step.terms = terms;
    step.token = &token;
    return formula_.steps_.emplace_back(step);
  }
  // A step that leaves one more operand on the stack than `taken` that it takes; false when that is too many.
  bool grow(std::size_t taken) {
    height_ = height_ + 1 - taken;
    return height_ <= Formula::kDeepestStack;
  }
  void operate(Operation operation, const Token& mark) {
    emit(operation, mark);
    --height_;
  }

  bool full(std::uint8_t terms) {
    const Level level(*this);
    if (!level.fits() || !logical(1) || next().is(Punctuation::question)) return false;
    if (terms != 1) emit(Operation::promote, next(), terms);
    return true;
  }

  bool logical(std::uint8_t terms) {
    if (!comparison(terms)) return false;
    while (next().is(Punctuation::ampersand) || next().is(Punctuation::bar)) {
      const Token& mark = take();
      if (!comparison(Formula::kOfLeft)) return false;
      operate(Operation::truth, mark);
    }
    return true;
  }

  bool comparison(std::uint8_t terms) {
    if (!sum(terms)) return false;
    while (is_comparison(next())) {
      const Token& mark = take();
      if (!sum(Formula::kOfLeft)) return false;
      operate(Operation::truth, mark);
    }
    return true;
  }

  bool sum(std::uint8_t terms) {
    if (!product(terms)) return false;
    while (next().is(Punctuation::plus) || next().is(Punctuation::dash)) {
      const Token& mark = take();
      if (!product(Formula::kOfLeft)) return false;
      operate(mark.is(Punctuation::plus) ? Operation::add : Operation::subtract, mark);
    }
    return true;
  }

  bool product(std::uint8_t terms) {
    if (!operand(terms)) return false;
    while (next().is(Punctuation::star) || next().is(Punctuation::slash)) {
      const Token& mark = take();
      if (!operand(Formula::kOfLeft)) return false;
      operate(mark.is(Punctuation::star) ? Operation::multiply : Operation::divide, mark);
    }
    return true;
  }

  bool operand(std::uint8_t terms) {
    const Level level(*this);
    while (next().is(Punctuation::plus)) ++at_;
    if (!level.fits() || !operand_alone(terms)) return false;
    return !accept(Punctuation::period) || component();
  }

  bool operand_alone(std::uint8_t terms) {
    const Token& token = take();
    switch (token.kind) {
      case TokenKind::number:
        emit(Operation::number, token, terms).number = token.number;
        return grow(0);
      case TokenKind::identifier:
        return name(token, terms);
      case TokenKind::keyword:
        return word(token, terms);
      case TokenKind::punctuation:
        return sign(token, terms);
      default:
        return false;
    }
  }

  bool name(const Token& token, std::uint8_t terms) {
    if (next().is(Punctuation::left_paren) || next().is(Punctuation::left_bracket)) return false;
    std::vector<std::uint32_t>& names = formula_.names_;
    const auto found = std::find(names.begin(), names.end(), token.symbol);
    const auto index = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) {
      if (names.size() == Formula::kMostNames) return false;
      names.push_back(token.symbol);
    }
    emit(Operation::name, token, terms).index = static_cast<std::uint8_t>(index);
    return grow(0);
  }

  bool sign(const Token& token, std::uint8_t terms) {
    switch (token.punctuation) {
      case Punctuation::dash:
      case Punctuation::exclamation:
        if (!operand(terms)) return false;
        emit(token.is(Punctuation::dash) ? Operation::negate : Operation::invert, token);
        return true;
      case Punctuation::left_paren:
        return full(terms) && accept(Punctuation::right_paren);
      case Punctuation::less:
        return vector(token);
      default:
        return false;
    }
  }

  // `<a, b>` to `<a, b, c, d, e>`, the `<` taken.
  bool vector(const Token& opening) {
    std::uint8_t count = 0;
    do {
      if (count == 5 || !number()) return false;
      if (++count < 5) accept(Punctuation::comma);
    } while (!next().is(Punctuation::greater));
    ++at_;
    emit(Operation::vector, opening).index = count;
    return count > 1 && grow(count);
  }

  bool component() {
    const Token& word = take();
    if (picked_component(word.keyword) == kNoComponent) return false;
    emit(Operation::component, word);
    return true;
  }

  // A sum that must give a single number, or a vector of at most three components.
  bool number() { return checked(Operation::check_float, 1); }
  bool further_number() {
    accept(Punctuation::comma);
    return number();
  }
  bool vector_argument() { return checked(Operation::check_vector, 3); }
  bool checked(Operation check, std::uint8_t terms) {
    const Token& first = next();
    if (!sum(terms)) return false;
    emit(check, first);
    return true;
  }

  bool word(const Token& token, std::uint8_t terms) {
    const auto& value = word_of(token.keyword).value;
    if (const auto* constant = std::get_if<Word::Constant>(&value)) {
      emit(Operation::number, token, terms).number = constant->value;
      return grow(0);
    }
    if (const auto* vector = std::get_if<Word::Unit>(&value)) {
      Formula::Step& step = emit(Operation::unit, token, terms);
      step.index = vector->component;
      step.number = vector->size;
      return grow(0) && !token.is(Keyword::t);  // which begins an expression only where nothing else can stand
    }
    return call(token, terms);
  }

  // A function of numbers or vectors.
  bool call(const Token& word, std::uint8_t terms) {
    const auto& value = word_of(word.keyword).value;
    if (!accept(Punctuation::left_paren)) return false;
    std::size_t arguments = 1;
    if (std::holds_alternative<Word::OfOne>(value)) {
      const Token& first = next();
      if (!full(1)) return false;
      emit(Operation::check_float, first);
      emit(Operation::call_number, word, terms);
    } else if (std::holds_alternative<Word::OfTwo>(value)) {
      if (!number() || !further_number()) return false;
      emit(Operation::call_two, word, terms);
      arguments = 2;
    } else if (std::holds_alternative<Word::Fold>(value)) {
      if (!number()) return false;
      while (accept(Punctuation::comma)) {
        if (!number()) return false;
        operate(Operation::fold, word);
      }
      emit(Operation::fold_end, word, terms);
    } else if (const auto* function = std::get_if<Word::OfVectors>(&value)) {
      if (!vector_argument()) return false;
      if (function->takes_second) {
        accept(Punctuation::comma);
        if (!vector_argument()) return false;
        ++arguments;
      }
      if (function->takes_degrees) {
        if (!further_number()) return false;
        ++arguments;
      }
      emit(Operation::call_vectors, word, terms);
    } else {
      return false;
    }
    return grow(arguments) && accept(Punctuation::right_paren);
  }

  const TokenFile& file_;
  const std::uint32_t begin_;
  std::uint32_t at_;
  Formula& formula_;
  std::size_t depth_ = 0;
  std::size_t height_ = 0;  // of the stack, behind the steps so far
};

std::unique_ptr<const Formula> Formula::compile(const TokenFile& file, std::uint32_t begin, Kind kind) {
  auto formula = std::make_unique<Formula>();
  FormulaCompiler compiler(file, begin, *formula);
  if (!compiler.compile(kind)) return nullptr;
  return formula;
}

}  // namespace firstlight::parser
