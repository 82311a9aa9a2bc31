#include "parser/expression/function_compiler.h"

#include "parser/expression/function_emitter.h"
#include "parser/expression/function_operators.h"
#include "parser/expression/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace firstlight::parser {

namespace {

using render::Program;

constexpr int kDeepest = 200;
constexpr std::string_view kTooLarge = "the expression is too large";

class Compiler {
 public:
  using Operation = render::Operation;

  Compiler(std::span<const Token> tokens, const FunctionScope& scope) : tokens_(tokens), scope_(scope) {}

  std::shared_ptr<const Program> run() {
    expression();
    if (at_ < tokens_.size() && !next().is_end()) fail_expected("an operator or the end of the expression");
    return emitter_.finish(scope_.parameters.size());
  }

 private:
  const Token& next() const { return tokens_[std::min(at_, tokens_.size() - 1)]; }
  bool accept(Punctuation mark) {
    if (at_ >= tokens_.size() || !next().is(mark)) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(const Token& at, std::string message) const {
    throw FunctionError{at.location, std::move(message), kNoSymbol};
  }
  [[noreturn]] void fail_expected(const std::string& what) const {
    const bool end = next().is_end() || at_ >= tokens_.size();
    fail(next(), "expected " + what + ", found " + (end ? std::string("the end") : describe(next())));
  }
  void expect(Punctuation mark, const std::string& purpose) {
    if (!accept(mark)) fail_expected("'" + std::string(spelling(mark)) + "' " + purpose);
  }

  void expression() { binary(0); }

  /// An operator with a constant on its right, as the last that was emitted: behind `mark` instructions.
  struct Joinable {
    Operation operation;
    double right;
    std::size_t mark;
  };

  /// An operand and the operators of `rank` and above behind it. The ranks take turns at what is there already, so
  /// that the depth of the stack is that of the parentheses.
  void binary(std::size_t rank) {
    const std::size_t start = emitter_.mark();
    operand();
    for (std::size_t above = kRankCount; above-- > rank;) row(above, start);
  }

  /// Operators of one rank in a row, behind the first operand, which begins at `start`.
  void row(std::size_t rank, std::size_t start) {
    std::optional<Joinable> last;
    while (at_ < tokens_.size() && next().kind == TokenKind::punctuation) {
      const auto found = std::ranges::find(kRanks[rank], next().punctuation, &Binary::mark);
      if (found == kRanks[rank].end()) return;
      const Token& at = tokens_[at_++];
      Operation operation = found->operation;
      const std::size_t begin = at_;
      const std::size_t mark = emitter_.mark();
      binary(rank + 1);
      if (std::optional<double> right = emitter_.take_constant(mark)) {
        if (operation == Operation::subtract && at_ == begin + 1) {  // a number by itself
          operation = Operation::add;
          right = -*right;
        }
        join(last, operation, *right, start, at);
      } else {
        last.reset();
        apply(operation, at);
      }
    }
  }

  /// Applies an operator with a constant on its right: to the constant before it, or to all that is on its left.
  void join(std::optional<Joinable>& last, Operation operation, double right, std::size_t start, const Token& at) {
    const auto of_constants = [&](double left) {
      return render::apply({operation, 0, 0, 0.0}, std::array{left, right}.data());
    };
    const bool product = operation == Operation::multiply || operation == Operation::divide;
    if (last && !(product && emitter_.varies_since(start))) {
      right = of_constants(last->right);
      operation = last->operation;
      emitter_.return_to(last->mark);
    } else if (const std::optional<double> left = emitter_.take_constant(start)) {
      emitter_.constant(of_constants(*left));
      return;
    }
    if (operation == Operation::divide && right == 0.0) fail(at, "division by zero");
    last = Joinable{operation, right, emitter_.mark()};
    emitter_.apply_constant(operation, right);
    if (!emitter_.fits()) fail(at, std::string(kTooLarge));
  }

  void apply(Operation operation, const Token& at) {
    emitter_.apply(operation);
    if (!emitter_.fits()) fail(at, std::string(kTooLarge));
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
    if (token.kind == TokenKind::number) {
      ++at_;
      emitter_.constant(token.number);
    } else if (token.is(Punctuation::left_paren)) {
      ++at_;
      if (++depth_ > kDeepest) fail(token, "parentheses are nested more than " + std::to_string(kDeepest) + " deep");
      expression();
      --depth_;
      expect(Punctuation::right_paren, "to close the parenthesis");
    } else if (!variable(token)) {
      if (token.kind == TokenKind::identifier) {
        name(token);
      } else if (token.kind == TokenKind::keyword) {
        ++at_;
        word(token);
      } else {
        fail_expected("a number");
      }
    }
    if (!emitter_.fits()) fail(token, std::string(kTooLarge));
  }

  /// A parameter, a loop's variable or a coordinate. False: the token is none.
  bool variable(const Token& token) {
    if (token.kind != TokenKind::identifier && token.kind != TokenKind::keyword) return false;
    const auto local = std::ranges::find(locals_.rbegin(), locals_.rend(), token.text, &Local::name);
    const auto parameter = std::ranges::find(scope_.parameters, token.text);
    if (local != locals_.rend()) {
      emitter_.local(local->place);
    } else if (parameter != scope_.parameters.end()) {
      emitter_.parameter(static_cast<std::size_t>(parameter - scope_.parameters.begin()));
    } else if (!coordinate(token)) {
      return false;
    }
    ++at_;
    return true;
  }

  /// x, y, z, u or v that is no parameter: the parameter of its like, or 0.
  bool coordinate(const Token& token) {
    if (!scope_.has_coordinates || token.kind != TokenKind::keyword) return false;
    constexpr std::pair<Keyword, std::string_view> kLikes[] = {
        {Keyword::x, "u"}, {Keyword::u, "x"}, {Keyword::y, "v"}, {Keyword::v, "y"}, {Keyword::z, ""}};
    const auto* like = std::ranges::find(kLikes, token.keyword, &std::pair<Keyword, std::string_view>::first);
    if (like == std::end(kLikes)) return false;
    const auto parameter = std::ranges::find(scope_.parameters, like->second);
    if (parameter == scope_.parameters.end()) {
      emitter_.constant(0.0);
    } else {
      emitter_.parameter(static_cast<std::size_t>(parameter - scope_.parameters.begin()));
    }
    return true;
  }

  /// Emits the value of a name outside of the function.
  void name(const Token& token) {
    const FunctionName* meaning = at_ < scope_.names.size() ? &scope_.names[at_] : nullptr;
    if (meaning == nullptr || (meaning->size == 0 && !meaning->function)) {
      throw FunctionError{token.location, unknown(token), token.symbol};
    }
    ++at_;
    if (meaning->function) return call(token, meaning->function);
    if (meaning->size == 1) return emitter_.constant(meaning->values[0]);
    const std::uint8_t component = member(token, meaning->size);
    emitter_.constant(component == render::kGrayComponent
                          ? 0.297 * meaning->values[0] + 0.589 * meaning->values[1] + 0.114 * meaning->values[2]
                          : meaning->values[component]);
  }

  void call(const Token& token, const render::FunctionPtr& function) {
    arguments(token, function->parameter_count(), function->parameter_count());
    const std::uint8_t component = function->result_count() > 1 ? member(token, function->result_count()) : 0;
    emitter_.call(function, component);
    if (!emitter_.is_affordable()) fail(token, "functions call each other too often or too deep here");
  }

  /// `.x`, `.red` ... behind a vector of `size` components.
  std::uint8_t member(const Token& of, std::size_t size) {
    expect(Punctuation::period, "behind '" + std::string(of.text) + "', which is a vector");
    constexpr std::pair<std::string_view, std::uint8_t> kMembers[] = {{"x", 0},
                                                                      {"y", 1},
                                                                      {"z", 2},
                                                                      {"t", 3},
                                                                      {"u", 0},
                                                                      {"v", 1},
                                                                      {"red", 0},
                                                                      {"green", 1},
                                                                      {"blue", 2},
                                                                      {"filter", 3},
                                                                      {"transmit", 4},
                                                                      {"gray", render::kGrayComponent},
                                                                      {"grey", render::kGrayComponent},
                                                                      {"hf", render::kHeightComponent}};
    const Token& word = next();
    const auto* found = std::ranges::find(kMembers, word.text, &std::pair<std::string_view, std::uint8_t>::first);
    if (at_ >= tokens_.size() || found == std::end(kMembers)) fail_expected("a component such as 'x' or 'red'");
    const std::size_t needed = found->second < render::kGrayComponent ? found->second + 1u : 3u;
    if (needed > size) {
      fail(word, "a value of " + std::to_string(size) + " components has no '." + std::string(word.text) + "'");
    }
    ++at_;
    return found->second;
  }

  /// `sum(i, first, last, expression)`
  void loop(const Token& token, double neutral, Operation end) {
    const std::string of = "of '" + std::string(token.text) + "'";
    expect(Punctuation::left_paren, "before the arguments " + of);
    if (++depth_ > kDeepest) fail(token, "functions are nested more than " + std::to_string(kDeepest) + " deep");
    const Token variable = next();
    if (variable.kind != TokenKind::identifier && variable.kind != TokenKind::keyword) {
      fail_expected("the name of a variable");
    }
    ++at_;
    const std::size_t place = emitter_.height();
    for (int i = 0; i < 2; ++i) {
      expect(Punctuation::comma, "and a further argument " + of);
      expression();
    }
    expect(Punctuation::comma, "and a further argument " + of);
    const std::size_t begin = emitter_.begin_loop(neutral);
    locals_.push_back({variable.text, place});
    expression();
    locals_.pop_back();
    emitter_.end_loop(begin, end);
    --depth_;
    expect(Punctuation::right_paren, "behind the arguments " + of);
  }

  std::string unknown(const Token& token) const {
    std::string message = "expected a number, found the unknown name '" + std::string(token.text) + "'";
    for (std::size_t i = 0; i < scope_.parameters.size(); ++i) {
      message += (i == 0 ? "; there are " : ", ") + std::string(scope_.parameters[i]);
    }
    return message;
  }

  void word(const Token& token) {
    const Word& meaning = word_of(token.keyword);
    if (const auto* constant = std::get_if<Word::Constant>(&meaning.value)) return emitter_.constant(constant->value);
    switch (token.keyword) {
      case Keyword::clock:
        return emitter_.constant(scope_.clock);
      case Keyword::sum:
        return loop(token, 0.0, Operation::end_sum);
      case Keyword::prod:
        return loop(token, 1.0, Operation::end_product);
      case Keyword::pow:
        return power(token);
      case Keyword::degrees:
        return scaled(token, 180.0, std::numbers::pi);
      case Keyword::radians:
        return scaled(token, std::numbers::pi, 180.0);
      case Keyword::select:
        return apply(arguments(token, 3, 4) == 3 ? Operation::select_negative : Operation::select, token);
      default:
        break;
    }
    if (!meaning.operation) {
      fail(token, "expected a number, found '" + std::string(token.text) + "', which is no function of numbers");
    }
    if (std::holds_alternative<Word::Fold>(meaning.value)) {
      arguments(token, 2, tokens_.size(), &*meaning.operation);
    } else {
      const std::size_t count = std::holds_alternative<Word::OfTwo>(meaning.value) ? 2 : 1;
      arguments(token, count, count);
      apply(*meaning.operation, token);
    }
  }

  void power(const Token& token) {
    const std::string of = "of 'pow'";
    const std::size_t base = emitter_.mark();
    expect(Punctuation::left_paren, "before the arguments " + of);
    if (++depth_ > kDeepest) fail(token, "functions are nested more than " + std::to_string(kDeepest) + " deep");
    expression();
    if (!accept(Punctuation::comma)) fail_expected("',' and a further argument " + of);
    const std::size_t mark = emitter_.mark();
    expression();
    if (next().is(Punctuation::comma)) fail(token, "too many arguments " + of);
    if (const std::optional<double> exponent = emitter_.take_constant(mark)) {
      if (*exponent == 0.0) {
        emitter_.replace_since(base, 1.0);
      } else if (const std::optional<double> known = emitter_.take_constant(base)) {
        emitter_.constant(std::pow(*known, *exponent));
      } else {
        emitter_.apply_constant(Operation::power, *exponent);
      }
    } else {
      apply(Operation::power, token);
    }
    --depth_;
    expect(Punctuation::right_paren, "behind the arguments " + of);
  }

  /// Angles: a constant is multiplied first, anything else by the quotient. [POV-Ray 3.7]
  void scaled(const Token& token, double factor, double divisor) {
    const std::size_t mark = emitter_.mark();
    arguments(token, 1, 1);
    if (const std::optional<double> angle = emitter_.take_constant(mark)) {
      emitter_.constant(*angle * factor / divisor);
    } else {
      emitter_.apply_constant(Operation::multiply, factor / divisor);
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

  struct Local {
    std::string_view name;
    std::size_t place;  ///< on the stack
  };

  std::span<const Token> tokens_;
  const FunctionScope& scope_;
  std::vector<Local> locals_;
  Emitter emitter_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::shared_ptr<const Program> compile_function(std::span<const Token> tokens, const FunctionScope& scope) {
  return Compiler(tokens, scope).run();
}

}  // namespace firstlight::parser
