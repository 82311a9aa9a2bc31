#include "parser/expression/expression.h"

#include "parser/expression/call.h"
#include "parser/expression/evaluator.h"
#include "parser/expression/string_expression.h"
#include "parser/expression/words.h"

#include <limits>

#include <fmt/format.h>

namespace firstlight::parser {

namespace {

Numbers parse_operand(Evaluator& in, std::uint8_t terms);

// `<a, b>` to `<a, b, c, d, e>`, the `<` taken.
Numbers parse_vector_literal(Evaluator& in) {
  Numbers result;
  result.size = 0;
  while (result.size < 2 || (result.size < 5 && at_expression(in))) {
    result.values[result.size++] = parse_float(in);
    if (result.size < 5 && in.peek().is(Punctuation::comma)) in.take();
  }
  in.expect(Punctuation::greater, "to close the vector");
  return result;
}

// `.x`, `.red` ... behind an operand.
void take_component(Evaluator& in, Numbers& numbers) {
  in.take();
  const Token& word = in.peek();
  if (picked_component(word.keyword) == kNoComponent) {
    in.fail(word.location, "expected a component such as 'x' or 'red' after '.', found " + in.describe_next());
  }
  in.take();
  numbers = single(pick_component(in, word, numbers), 1);
}

Numbers parse_operand_alone(Evaluator& in, std::uint8_t terms) {
  const Evaluator::Nesting nesting(in);
  while (in.peek().is(Punctuation::plus)) in.take();
  const Token& token = in.peek();
  switch (token.kind) {
    case TokenKind::number:
      in.take();
      return single(token.number, terms);
    case TokenKind::identifier: {
      const Value* value = in.peek_value();
      if (value == nullptr) break;
      if (const auto* numbers = std::get_if<Numbers>(value)) {  // behind a `+`, or from a macro
        const Numbers result = fitted(*numbers, terms);
        in.take();
        return result;
      }
      if (at_call(in)) {
        const Numbers result = parse_call(in);
        return result.size == 1 ? single(result.values[0], terms) : result;
      }
      break;
    }
    case TokenKind::keyword: {
      const WordKind kind = word_kind(token.keyword);
      if (kind != WordKind::number && kind != WordKind::vector) break;
      in.take();
      return fitted(parse_function(in, token), terms);
    }
    case TokenKind::punctuation:
      if (token.is(Punctuation::dash)) {
        in.take();
        Numbers result = parse_operand(in, terms);
        change(result, negated);
        return result;
      }
      if (token.is(Punctuation::exclamation)) {
        in.take();
        Numbers result = parse_operand(in, terms);
        change(result, inverted);
        return result;
      }
      if (token.is(Punctuation::left_paren)) {
        in.take();
        const Numbers result = parse_full_expression(in, terms);
        in.expect(Punctuation::right_paren, "to close the parenthesis");
        return result;
      }
      if (token.is(Punctuation::less)) {
        in.take();
        return parse_vector_literal(in);
      }
      break;
    default:
      break;
  }
  in.fail(token.location, "expected a numeric expression, found " + in.describe_next());
}

// The numbers that the next name stands for; null when it is no number or vector.
const Numbers* numbers_of_name(Evaluator& in) {
  const Value* const value = in.peek_value();
  return value != nullptr ? std::get_if<Numbers>(value) : nullptr;
}

Numbers parse_operand(Evaluator& in, std::uint8_t terms) {
  Numbers result;
  if (const Token& token = in.peek(); token.kind == TokenKind::number) {
    result.values[0] = token.number;
    promote(result, terms);
    in.take();
  } else if (const auto* numbers = numbers_of_name(in)) {
    result = fitted(*numbers, terms);
    in.take();
  } else {
    const Evaluator::Release release(in);
    result = parse_operand_alone(in, terms);
  }
  if (in.peek().is(Punctuation::period)) take_component(in, result);
  return result;
}

Numbers parse_product(Evaluator& in, std::uint8_t terms) {
  Numbers left = parse_operand(in, terms);
  for (;;) {
    const Token& mark = in.peek();
    if (mark.is(Punctuation::star)) {
      in.take();
      left = combine(left, parse_operand(in, left.size), [](double a, double b) { return a * b; });
    } else if (mark.is(Punctuation::slash)) {
      in.take();
      left = combine(left, parse_operand(in, left.size), [&](double a, double b) { return divide(in, mark, a, b); });
    } else {
      return left;
    }
  }
}

Numbers parse_sum_by_tokens(Evaluator& in, std::uint8_t terms) {
  Numbers left = parse_product(in, terms);
  for (;;) {
    const Token& mark = in.peek();
    if (mark.is(Punctuation::plus)) {
      in.take();
      left = combine(left, parse_product(in, left.size), [](double a, double b) { return a + b; });
    } else if (mark.is(Punctuation::dash)) {
      in.take();
      left = combine(left, parse_product(in, left.size), [](double a, double b) { return a - b; });
    } else {
      return left;
    }
  }
}

Numbers parse_comparison(Evaluator& in, std::uint8_t terms) {
  bool strings = false;
  {
    const Evaluator::Release release(in);
    strings = at_string(in);
  }
  if (strings) {
    const std::string left = parse_string(in);
    const Token& mark = in.peek();
    if (!is_comparison(mark)) {
      in.fail(mark.location, "expected a comparison behind the string, found " + in.describe_next());
    }
    in.take();
    const int order = left.compare(parse_string(in));
    return single(compare(mark.punctuation, order, 0.0) ? 1.0 : 0.0, terms);
  }
  Numbers left = parse_sum(in, terms);
  while (is_comparison(in.peek())) {
    const Punctuation mark = in.take().punctuation;
    left = combine(left, parse_sum(in, left.size), [mark](double a, double b) { return truth(mark, a, b); });
  }
  return left;
}

Numbers parse_logical(Evaluator& in, std::uint8_t terms) {
  Numbers left = parse_comparison(in, terms);
  for (;;) {
    const Token& mark = in.peek();
    if (!mark.is(Punctuation::ampersand) && !mark.is(Punctuation::bar)) return left;
    in.take();
    left = combine(left, parse_comparison(in, left.size),
                   [&](double a, double b) { return truth(mark.punctuation, a, b); });
  }
}

Numbers parse_full_by_tokens(Evaluator& in, std::uint8_t terms) {
  const Evaluator::Nesting nesting(in);
  const Location first = in.peek().location;
  Numbers result = parse_logical(in, 1);
  if (!in.peek().is(Punctuation::question)) {
    promote(result, terms);
    return result;
  }
  if (result.size != 1) fail_components(in, first, "float before '?'", result);
  in.take();
  // Both are evaluated, whatever the condition: `rand` advances in either.
  const Numbers if_true = parse_full_expression(in, terms);
  in.expect(Punctuation::colon, "of '?:'");
  const Numbers if_false = parse_full_expression(in, terms);
  return is_true(result.values[0]) ? if_true : if_false;
}

// An expression, by the formula for it if there is one. `at` becomes its first token.
Numbers parse_numbers(Evaluator& in, Formula::Kind kind, std::uint8_t terms, Location& at) {
  Numbers result;
  const Formula* const formula = in.next_formula(kind);
  if (formula != nullptr && in.evaluate(*formula, terms, result)) {
    at = formula->first().location;
    return result;
  }
  at = in.peek().location;
  return kind == Formula::Kind::sum ? parse_sum_by_tokens(in, terms) : parse_full_by_tokens(in, terms);
}

}  // namespace

void fail_components(Evaluator& in, const Location& at, std::string_view expected, const Numbers& found) {
  in.fail(at, "expected a " + std::string(expected) + ", found a " + std::string(kind_name(found)) + " expression");
}

double divide(Evaluator& in, const Token& mark, double a, double b) {
  if (b != 0.0) return a / b;
  in.warn(mark.location, "division by zero");
  return std::numeric_limits<double>::infinity();
}

double pick_component(Evaluator& in, const Token& word, const Numbers& numbers) {
  const std::size_t component = picked_component(word.keyword);
  const auto& v = numbers.values;
  if (component == kGray) return 0.297 * v[0] + 0.589 * v[1] + 0.114 * v[2];  // the weights of POV-Ray's grey scale
  if (component < numbers.size) return v[component];
  in.fail(word.location,
          "a value of " + std::to_string(int{numbers.size}) + " components has no '." + std::string(word.text) + "'");
}

Numbers parse_sum(Evaluator& in, std::uint8_t terms) {
  Location at;
  return parse_numbers(in, Formula::Kind::sum, terms, at);
}

Numbers parse_full_expression(Evaluator& in, std::uint8_t terms) {
  Location at;
  return parse_numbers(in, Formula::Kind::full, terms, at);
}

double parse_float(Evaluator& in) {
  Location at;
  const Numbers numbers = parse_numbers(in, Formula::Kind::sum, 1, at);
  if (numbers.size != 1) fail_components(in, at, "float", numbers);
  return numbers.values[0];
}

render::Vec3 parse_vector(Evaluator& in) {
  Location at;
  const Numbers numbers = parse_numbers(in, Formula::Kind::sum, 3, at);
  if (numbers.size > 3) fail_components(in, at, "vector", numbers);
  return {numbers.values[0], numbers.values[1], numbers.values[2]};
}

double parse_condition(Evaluator& in) {
  const Evaluator::Hold hold(in);
  Numbers numbers;
  const Formula* const formula =
      in.next_formula(Formula::Kind::full, Punctuation::left_paren, Punctuation::right_paren);
  if (formula != nullptr && in.evaluate(*formula, 1, numbers, Punctuation::right_paren)) {
    if (numbers.size != 1) fail_components(in, formula->first().location, "float", numbers);
    return numbers.values[0];
  }
  in.expect(Punctuation::left_paren, "before the condition");
  const Location at = in.peek().location;
  numbers = parse_full_by_tokens(in, 1);
  if (numbers.size != 1) fail_components(in, at, "float", numbers);
  in.expect(Punctuation::right_paren, "behind the condition");
  return numbers.values[0];
}

std::pair<double, double> parse_two_numbers(Evaluator& in) {
  in.expect(Punctuation::left_paren, "before the two numbers");
  const double first = parse_float(in);
  if (in.peek().is(Punctuation::comma)) in.take();
  const double second = parse_float(in);
  in.expect(Punctuation::right_paren, "behind the two numbers");
  return {first, second};
}

bool at_expression(Evaluator& in) {
  const Token& token = in.peek();
  if (token.kind == TokenKind::number) return true;
  if (token.kind == TokenKind::keyword) {
    const WordKind kind = word_kind(token.keyword);
    return (kind == WordKind::number || kind == WordKind::vector || kind == WordKind::color) &&
           token.keyword != Keyword::t;
  }
  if (token.kind == TokenKind::identifier) {
    const Value* value = in.peek_value();
    return value != nullptr && (std::holds_alternative<Numbers>(*value) || at_call(in));
  }
  return token.is(Punctuation::less) || token.is(Punctuation::left_paren) || token.is(Punctuation::plus) ||
         token.is(Punctuation::dash) || token.is(Punctuation::exclamation);
}

bool at_float(Evaluator& in) {
  const Token& token = in.peek();
  if (token.kind == TokenKind::number) return true;
  if (token.kind == TokenKind::keyword) return word_kind(token.keyword) == WordKind::number;
  if (token.kind == TokenKind::identifier) {
    const Value* value = in.peek_value();
    const auto* numbers = value != nullptr ? std::get_if<Numbers>(value) : nullptr;
    if (numbers != nullptr) return numbers->size == 1;
    const auto* function = value != nullptr ? std::get_if<render::FunctionPtr>(value) : nullptr;
    return function != nullptr && (*function)->result_count() == 1;
  }
  return token.is(Punctuation::left_paren) || token.is(Punctuation::plus) || token.is(Punctuation::dash) ||
         token.is(Punctuation::exclamation);
}

std::string number_text(double value) { return fmt::format("{:g}", value); }

}  // namespace firstlight::parser
