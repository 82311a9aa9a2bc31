#include "parser/directive/reader.h"

#include "parser/directive/interpreter.h"
#include "parser/expression/expression.h"
#include "parser/expression/string_expression.h"

#include <utility>

namespace firstlight::parser {

Reader::Reader(Interpreter& interpreter) : interpreter_(interpreter), stream_(interpreter) {}

bool Reader::at_expression() { return parser::at_expression(interpreter_); }
bool Reader::at_number() { return at_float(interpreter_); }
double Reader::number() { return parse_float(interpreter_); }
render::Vec3 Reader::vector3() { return parse_vector(interpreter_); }

render::Vec2 Reader::vector2() {
  const Token& at = peek();
  const Numbers numbers = parse_sum(interpreter_, 2);
  if (numbers.size > 2) fail(at, "expected a 2D vector, found a " + std::string(kind_name(numbers)) + " expression");
  return {numbers.values[0], numbers.values[1]};
}

render::FilteredColor Reader::color() { return parse_color(interpreter_); }
double Reader::optional_number(double when_absent) { return at_expression() ? number() : when_absent; }
bool Reader::optional_flag(bool when_absent) { return is_true(optional_number(when_absent ? 1.0 : 0.0)); }
std::string Reader::string() { return parse_string(interpreter_); }
Numbers Reader::expression() { return parse_sum(interpreter_, 1); }

void Reader::fail(const Token& at, std::string message) { interpreter_.fail(at.location, std::move(message)); }

void Reader::fail_finally(const Token& at, std::string message) {
  interpreter_.fail_finally(at.location, std::move(message));
}

void Reader::fail_expected(std::string_view what) {
  const Token& at = peek();
  fail(at, "expected " + std::string(what) + ", found " + interpreter_.describe_next());
}

void Reader::warn(const Token& at, std::string message) { interpreter_.warn(at.location, std::move(message)); }

}  // namespace firstlight::parser
