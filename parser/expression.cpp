#include "parser/expression.h"

#include "parser/interpreter.h"
#include "parser/parse_function.h"
#include "parser/string_expression.h"

#include <limits>

#include <fmt/format.h>

namespace firstlight::parser {

namespace {

// A single number becomes equal components, a shorter vector is filled up with zeros.
void promote(Numbers& numbers, std::uint8_t terms) {
  if (numbers.size >= terms) return;
  const double fill = numbers.size == 1 ? numbers.values[0] : 0.0;
  for (std::size_t i = numbers.size; i < terms; ++i) numbers.values[i] = fill;
  numbers.size = terms;
}

Numbers single(double value, std::uint8_t terms) {
  Numbers result;
  result.values[0] = value;
  promote(result, terms);
  return result;
}

// A function's or name's value where `terms` components are wanted. Vectors of three keep further components at zero;
// those of two, four and five are what they are.
Numbers fitted(Numbers value, std::uint8_t terms) {
  if (value.size == 1) promote(value, terms);
  if (value.size == 3 && terms > 3) value.size = terms;
  return value;
}

template <class Operation>
Numbers combine(Numbers left, Numbers right, Operation operation) {
  if (left.size == 1 && right.size == 1) {  // most of them
    left.values[0] = operation(left.values[0], right.values[0]);
    left.is_color = false;
    return left;
  }
  promote(left, right.size);
  promote(right, left.size);
  for (std::size_t i = 0; i < left.size; ++i) left.values[i] = operation(left.values[i], right.values[i]);
  left.is_color = false;
  return left;
}

Numbers parse_operand(Interpreter& in, std::uint8_t terms);

// `<a, b>` to `<a, b, c, d, e>`, the `<` taken.
Numbers parse_vector_literal(Interpreter& in) {
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
void pick_component(Interpreter& in, Numbers& numbers) {
  in.take();
  const Token& word = in.peek();
  std::size_t component = 0;
  switch (word.keyword) {
    case Keyword::x:
    case Keyword::u:
    case Keyword::red:
      component = 0;
      break;
    case Keyword::y:
    case Keyword::v:
    case Keyword::green:
      component = 1;
      break;
    case Keyword::z:
    case Keyword::blue:
      component = 2;
      break;
    case Keyword::t:
    case Keyword::filter:
      component = 3;
      break;
    case Keyword::transmit:
      component = 4;
      break;
    case Keyword::gray: {
      in.take();
      // Weights of POV-Ray's grey scale.
      const auto& v = numbers.values;
      numbers = single(0.297 * v[0] + 0.589 * v[1] + 0.114 * v[2], 1);
      return;
    }
    default:
      in.fail(word.location, "expected a component such as 'x' or 'red' after '.', found " + in.describe_next());
  }
  if (component >= numbers.size) {
    in.fail(word.location,
            "a value of " + std::to_string(int{numbers.size}) + " components has no '." + std::string(word.text) + "'");
  }
  in.take();
  numbers = single(numbers.values[component], 1);
}

Numbers parse_operand_alone(Interpreter& in, std::uint8_t terms) {
  const Interpreter::Nesting nesting(in);
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
        for (std::size_t i = 0; i < result.size; ++i) result.values[i] = -result.values[i];
        return result;
      }
      if (token.is(Punctuation::exclamation)) {
        in.take();
        Numbers result = parse_operand(in, terms);
        for (std::size_t i = 0; i < result.size; ++i) result.values[i] = is_true(result.values[i]) ? 0.0 : 1.0;
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

// What the name that is next stands for; null when it is no number or vector.
const Numbers* numbers_of_name(Interpreter& in) {
  const Value* const value = in.peek_value();
  return value != nullptr ? std::get_if<Numbers>(value) : nullptr;
}

Numbers parse_operand(Interpreter& in, std::uint8_t terms) {
  Numbers result;
  if (const Token& token = in.peek(); token.kind == TokenKind::number) {
    result.values[0] = token.number;
    promote(result, terms);
    in.take();
  } else if (const auto* numbers = numbers_of_name(in)) {
    result = fitted(*numbers, terms);
    in.take();
  } else {
    const Interpreter::Release release(in);
    result = parse_operand_alone(in, terms);
  }
  if (in.peek().is(Punctuation::period)) pick_component(in, result);
  return result;
}

Numbers parse_product(Interpreter& in, std::uint8_t terms) {
  Numbers left = parse_operand(in, terms);
  for (;;) {
    const Token& mark = in.peek();
    if (mark.is(Punctuation::star)) {
      in.take();
      left = combine(left, parse_operand(in, left.size), [](double a, double b) { return a * b; });
    } else if (mark.is(Punctuation::slash)) {
      in.take();
      left = combine(left, parse_operand(in, left.size), [&](double a, double b) {
        if (b != 0.0) return a / b;
        in.warn(mark.location, "division by zero");
        return std::numeric_limits<double>::infinity();
      });
    } else {
      return left;
    }
  }
}

bool is_comparison(const Token& token) {
  switch (token.punctuation) {
    case Punctuation::less:
    case Punctuation::less_equal:
    case Punctuation::equal:
    case Punctuation::not_equal:
    case Punctuation::greater_equal:
    case Punctuation::greater:
      return token.kind == TokenKind::punctuation;
    default:
      return false;
  }
}

// Order and equality as POV-Ray has them: `<` and `>` are exact, the others allow kSmallestTrue.
bool compare(Punctuation mark, double a, double b) {
  switch (mark) {
    case Punctuation::less:
      return a < b;
    case Punctuation::less_equal:
      return a <= b || !is_true(a - b);
    case Punctuation::equal:
      return !is_true(a - b);
    case Punctuation::not_equal:
      return is_true(a - b);
    case Punctuation::greater_equal:
      return a >= b || !is_true(a - b);
    default:
      return a > b;
  }
}

Numbers parse_comparison(Interpreter& in, std::uint8_t terms) {
  bool strings = false;
  {
    const Interpreter::Release release(in);
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
    left =
        combine(left, parse_sum(in, left.size), [mark](double a, double b) { return compare(mark, a, b) ? 1.0 : 0.0; });
  }
  return left;
}

Numbers parse_logical(Interpreter& in, std::uint8_t terms) {
  Numbers left = parse_comparison(in, terms);
  for (;;) {
    const Token& mark = in.peek();
    const bool both = mark.is(Punctuation::ampersand);
    if (!both && !mark.is(Punctuation::bar)) return left;
    in.take();
    left = combine(left, parse_comparison(in, left.size), [both](double a, double b) {
      return (both ? is_true(a) && is_true(b) : is_true(a) || is_true(b)) ? 1.0 : 0.0;
    });
  }
}

[[noreturn]] void fail_components(Interpreter& in, const Token& at, std::string_view expected, const Numbers& found) {
  in.fail(at.location,
          "expected a " + std::string(expected) + ", found a " + std::string(kind_name(found)) + " expression");
}

}  // namespace

Numbers parse_sum(Interpreter& in, std::uint8_t terms) {
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

Numbers parse_full_expression(Interpreter& in, std::uint8_t terms) {
  const Interpreter::Nesting nesting(in);
  const Token& first = in.peek();
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

double parse_float(Interpreter& in) {
  const Token& at = in.peek();
  const Numbers numbers = parse_sum(in, 1);
  if (numbers.size != 1) fail_components(in, at, "float", numbers);
  return numbers.values[0];
}

render::Vec3 parse_vector(Interpreter& in) {
  const Token& at = in.peek();
  const Numbers numbers = parse_sum(in, 3);
  if (numbers.size > 3) fail_components(in, at, "vector", numbers);
  return {numbers.values[0], numbers.values[1], numbers.values[2]};
}

double parse_condition(Interpreter& in) {
  const Interpreter::Hold hold(in);
  in.expect(Punctuation::left_paren, "before the condition");
  const Token& at = in.peek();
  const Numbers numbers = parse_full_expression(in, 1);
  if (numbers.size != 1) fail_components(in, at, "float", numbers);
  in.expect(Punctuation::right_paren, "behind the condition");
  return numbers.values[0];
}

std::pair<double, double> parse_two_numbers(Interpreter& in) {
  in.expect(Punctuation::left_paren, "before the two numbers");
  const double first = parse_float(in);
  if (in.peek().is(Punctuation::comma)) in.take();
  const double second = parse_float(in);
  in.expect(Punctuation::right_paren, "behind the two numbers");
  return {first, second};
}

bool at_expression(Interpreter& in) {
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

bool at_float(Interpreter& in) {
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
