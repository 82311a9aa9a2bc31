// Calls of functions and splines in expressions.
#include "parser/expression/call.h"

#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"

#include <array>
#include <optional>

namespace firstlight::parser {

namespace {

Numbers call_spline(Evaluator& in, const Token& name, const render::Spline& spline) {
  in.expect(Punctuation::left_paren, "after", name.text);
  const double at = parse_float(in);
  std::optional<render::SplineKind> kind;
  if (in.peek().is(Punctuation::comma)) {
    in.take();
    kind = spline_kind(in.peek());
    if (!kind)
      in.fail(in.peek().location, "expected a kind of spline such as 'linear_spline', found " + in.describe_next());
    in.take();
  }
  in.expect(Punctuation::right_paren, "to close", name.text);
  Numbers result;
  result.values = kind ? spline.as(*kind).value(at) : spline.value(at);
  result.size = static_cast<std::uint8_t>(spline.components());
  return result;
}

Numbers call_function(Evaluator& in, const Token& name, const render::Function& function) {
  in.expect(Punctuation::left_paren, "after", name.text);
  std::array<double, render::Function::kMostParameters> arguments{};
  for (std::size_t i = 0; i < function.parameter_count(); ++i) {
    if (i > 0 && in.peek().is(Punctuation::comma)) in.take();
    if (in.peek().is(Punctuation::right_paren)) {
      in.fail(in.peek().location, "expected " + std::to_string(function.parameter_count()) + " arguments for '" +
                                      std::string(name.text) + "', found " + std::to_string(i));
    }
    arguments[i] = parse_float(in);
  }
  in.expect(Punctuation::right_paren, "to close", name.text);
  return in.evaluate(function, arguments.data(), name);
}

}  // namespace

std::optional<render::SplineKind> spline_kind(const Token& token) {
  switch (token.keyword) {
    case Keyword::linear_spline:
      return render::SplineKind::linear;
    case Keyword::quadratic_spline:
      return render::SplineKind::quadratic;
    case Keyword::cubic_spline:
      return render::SplineKind::catmull_rom;
    case Keyword::natural_spline:
      return render::SplineKind::natural;
    default:
      return std::nullopt;
  }
}

bool at_call(Evaluator& in) {
  const Value* value = in.peek_value();
  return value != nullptr && (std::holds_alternative<render::FunctionPtr>(*value) ||
                              std::holds_alternative<std::shared_ptr<const render::Spline>>(*value));
}

Numbers parse_call(Evaluator& in) {
  const Token& name = in.peek();
  const Value callee = *in.peek_value();
  in.take();
  if (const auto* function = std::get_if<render::FunctionPtr>(&callee)) return call_function(in, name, **function);
  return call_spline(in, name, *std::get<std::shared_ptr<const render::Spline>>(callee));
}

}  // namespace firstlight::parser
