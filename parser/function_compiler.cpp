#include "parser/function_compiler.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace firstlight::parser {

namespace {

using render::Instruction;
using render::Operation;
using render::Program;

constexpr int kDeepest = 200;

/// Instructions under construction. What depends on constants only is a constant at once.
class Emitter {
 public:
  void push(const Instruction& instruction) {
    instructions_.push_back(instruction);
    deepest_ = std::max(deepest_, ++size_);
  }
  void constant(double value) { push({Operation::constant, 0, value}); }
  void parameter(std::size_t index) { push({Operation::parameter, static_cast<std::uint16_t>(index), 0.0}); }
  void apply(Operation operation) {
    const auto taken = static_cast<std::size_t>(operands(operation));
    const bool known = std::all_of(instructions_.end() - static_cast<std::ptrdiff_t>(taken), instructions_.end(),
                                   [](const Instruction& i) { return i.operation == Operation::constant; });
    instructions_.push_back({operation, 0, 0.0});
    size_ -= taken - 1;
    if (!known) return;
    const auto first = instructions_.end() - static_cast<std::ptrdiff_t>(taken) - 1;
    const double value = Program({first, instructions_.end()}, 0).evaluate(std::span<const double>());
    instructions_.erase(first, instructions_.end());
    instructions_.push_back({Operation::constant, 0, value});
  }
  bool fits() const { return instructions_.size() <= Program::kMostInstructions && deepest_ <= Program::kDeepest; }
  std::vector<Instruction> take() { return std::move(instructions_); }

 private:
  std::vector<Instruction> instructions_;
  std::size_t size_ = 0;
  std::size_t deepest_ = 0;
};

struct Function {
  Keyword word;
  Operation operation;
};

constexpr Function kOfOne[] = {
    {Keyword::abs, Operation::absolute},
    {Keyword::acos, Operation::arc_cosine},
    {Keyword::acosh, Operation::hyperbolic_arc_cosine},
    {Keyword::asin, Operation::arc_sine},
    {Keyword::asinh, Operation::hyperbolic_arc_sine},
    {Keyword::atan, Operation::arc_tangent},
    {Keyword::atanh, Operation::hyperbolic_arc_tangent},
    {Keyword::ceil, Operation::ceiling},
    {Keyword::cos, Operation::cosine},
    {Keyword::cosh, Operation::hyperbolic_cosine},
    {Keyword::degrees, Operation::degrees},
    {Keyword::exp, Operation::exponential},
    {Keyword::floor, Operation::floor},
    {Keyword::int_, Operation::integer},
    {Keyword::ln, Operation::natural_logarithm},
    {Keyword::log, Operation::logarithm},
    {Keyword::radians, Operation::radians},
    {Keyword::sin, Operation::sine},
    {Keyword::sinh, Operation::hyperbolic_sine},
    {Keyword::sqr, Operation::square},
    {Keyword::sqrt, Operation::square_root},
    {Keyword::tan, Operation::tangent},
    {Keyword::tanh, Operation::hyperbolic_tangent},
};
constexpr Function kOfTwo[] = {
    {Keyword::atan2, Operation::arc_tangent_of_two},
    {Keyword::div, Operation::integer_quotient},
    {Keyword::mod, Operation::remainder},
    {Keyword::pow, Operation::power},
};
constexpr Function kOfMany[] = {
    {Keyword::max, Operation::maximum},
    {Keyword::min, Operation::minimum},
};

const Operation* find(std::span<const Function> functions, Keyword word) {
  const auto found = std::ranges::find(functions, word, &Function::word);
  return found == functions.end() ? nullptr : &found->operation;
}

struct Binary {
  Punctuation mark;
  Operation operation;
};

/// The operators of two values by rank, the weakest first.
constexpr Binary kOr[] = {{Punctuation::bar, Operation::logical_or}};
constexpr Binary kAnd[] = {{Punctuation::ampersand, Operation::logical_and}};
constexpr Binary kCompare[] = {
    {Punctuation::equal, Operation::equal},     {Punctuation::not_equal, Operation::not_equal},
    {Punctuation::less, Operation::less},       {Punctuation::less_equal, Operation::less_or_equal},
    {Punctuation::greater, Operation::greater}, {Punctuation::greater_equal, Operation::greater_or_equal}};
constexpr Binary kSum[] = {{Punctuation::plus, Operation::add}, {Punctuation::dash, Operation::subtract}};
constexpr Binary kProduct[] = {{Punctuation::star, Operation::multiply}, {Punctuation::slash, Operation::divide}};
constexpr std::span<const Binary> kRanks[] = {kOr, kAnd, kCompare, kSum, kProduct};
constexpr std::size_t kRankCount = std::size(kRanks);

class Compiler {
 public:
  Compiler(std::span<const Token> tokens, const FunctionScope& scope) : tokens_(tokens), scope_(scope) {}

  std::shared_ptr<const Program> run() {
    expression();
    if (at_ < tokens_.size() && !next().is_end()) fail_expected("an operator or the end of the expression");
    return std::make_shared<const Program>(emitter_.take(), scope_.parameters.size());
  }

 private:
  const Token& next() const { return tokens_[std::min(at_, tokens_.size() - 1)]; }
  bool accept(Punctuation mark) {
    if (at_ >= tokens_.size() || !next().is(mark)) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(const Token& at, std::string message) const {
    throw FunctionError{at.location, std::move(message)};
  }
  [[noreturn]] void fail_expected(const std::string& what) const {
    const bool end = next().is_end() || at_ >= tokens_.size();
    fail(next(), "expected " + what + ", found " + (end ? std::string("the end") : describe(next())));
  }
  void expect(Punctuation mark, const std::string& purpose) {
    if (!accept(mark)) fail_expected("'" + std::string(spelling(mark)) + "' " + purpose);
  }

  void expression() { binary(0); }

  void binary(std::size_t rank) {
    if (rank == kRankCount) return operand();
    binary(rank + 1);
    for (;;) {
      const auto found = std::ranges::find_if(
          kRanks[rank], [&](const Binary& b) { return at_ < tokens_.size() && next().is(b.mark); });
      if (found == kRanks[rank].end()) return;
      const Token& at = next();
      ++at_;
      binary(rank + 1);
      apply(found->operation, at);
    }
  }

  void apply(Operation operation, const Token& at) {
    emitter_.apply(operation);
    if (!emitter_.fits()) fail(at, "the expression is too large");
  }

  void operand() {
    // Signs are taken here, not by recursion: a row of them may be of any length.
    std::vector<Operation> signs;
    const Token& at = next();
    for (;; ++at_) {
      if (at_ >= tokens_.size()) break;
      if (next().is(Punctuation::dash)) {
        signs.push_back(Operation::negate);
      } else if (next().is(Punctuation::exclamation)) {
        signs.push_back(Operation::logical_not);
      } else if (!next().is(Punctuation::plus)) {
        break;
      }
    }
    value();
    while (!signs.empty()) {
      apply(signs.back(), at);
      signs.pop_back();
    }
  }

  void value() {
    const Token& token = next();
    if (at_ >= tokens_.size() || token.is_end()) fail_expected("a number");
    if (const auto parameter = std::ranges::find(scope_.parameters, token.text);
        parameter != scope_.parameters.end() &&
        (token.kind == TokenKind::identifier || token.kind == TokenKind::keyword)) {
      ++at_;
      emitter_.parameter(static_cast<std::size_t>(parameter - scope_.parameters.begin()));
    } else if (token.kind == TokenKind::number) {
      ++at_;
      emitter_.constant(token.number);
    } else if (token.kind == TokenKind::identifier) {
      const std::optional<double> number = scope_.constant ? scope_.constant(token) : std::nullopt;
      if (!number) fail(token, unknown(token));
      ++at_;
      emitter_.constant(*number);
    } else if (token.is(Punctuation::left_paren)) {
      ++at_;
      if (++depth_ > kDeepest) fail(token, "parentheses are nested more than " + std::to_string(kDeepest) + " deep");
      expression();
      --depth_;
      expect(Punctuation::right_paren, "to close the parenthesis");
    } else if (token.kind == TokenKind::keyword) {
      ++at_;
      word(token);
    } else {
      fail_expected("a number");
    }
    if (!emitter_.fits()) fail(token, "the expression is too large");
  }

  std::string unknown(const Token& token) const {
    std::string message = "expected a number, found the unknown name '" + std::string(token.text) + "'";
    for (std::size_t i = 0; i < scope_.parameters.size(); ++i) {
      message += (i == 0 ? "; there are " : ", ") + std::string(scope_.parameters[i]);
    }
    return message;
  }

  void word(const Token& token) {
    switch (token.keyword) {
      case Keyword::pi:
        return emitter_.constant(std::numbers::pi);
      case Keyword::true_:
      case Keyword::yes:
      case Keyword::on:
        return emitter_.constant(1.0);
      case Keyword::false_:
      case Keyword::no:
      case Keyword::off:
        return emitter_.constant(0.0);
      case Keyword::select:
        return apply(arguments(token, 3, 4) == 3 ? Operation::select_negative : Operation::select, token);
      default:
        break;
    }
    if (const Operation* of_one = find(kOfOne, token.keyword)) {
      arguments(token, 1, 1);
      apply(*of_one, token);
    } else if (const Operation* of_two = find(kOfTwo, token.keyword)) {
      arguments(token, 2, 2);
      apply(*of_two, token);
    } else if (const Operation* of_many = find(kOfMany, token.keyword)) {
      arguments(token, 2, tokens_.size(), of_many);
    } else {
      fail(token, "expected a number, found '" + std::string(token.text) + "', which is no function of numbers");
    }
  }

  /// Reads `( expression, ... )`; `joined` is applied to each but the first. Returns how many there were.
  std::size_t arguments(const Token& function, std::size_t least, std::size_t most, const Operation* joined = nullptr) {
    const std::string of = "of '" + std::string(function.text) + "'";
    expect(Punctuation::left_paren, "before the arguments " + of);
    if (++depth_ > kDeepest) fail(function, "functions are nested more than " + std::to_string(kDeepest) + " deep");
    std::size_t count = 0;
    do {
      if (count == most) fail(function, "too many arguments " + of);
      expression();
      if (count++ > 0 && joined != nullptr) apply(*joined, function);
    } while (accept(Punctuation::comma));
    if (count < least) fail_expected("',' and a further argument " + of);
    --depth_;
    expect(Punctuation::right_paren, "behind the arguments " + of);
    return count;
  }

  std::span<const Token> tokens_;
  const FunctionScope& scope_;
  Emitter emitter_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::shared_ptr<const Program> compile_function(std::span<const Token> tokens, const FunctionScope& scope) {
  return Compiler(tokens, scope).run();
}

}  // namespace firstlight::parser
