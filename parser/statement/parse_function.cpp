// `function { }`: its text is collected with all names resolved, then compiled.
#include "parser/statement/parse_function.h"

#include "parser/directive/interpreter.h"
#include "parser/expression/function_compiler.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"
#include "render/function/internal.h"
#include "render/function/transform_function.h"
#include "render/surface/texture_function.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace firstlight::parser {

namespace {

constexpr std::size_t kMostBodyTokens = 200'000;
constexpr std::array<std::string_view, 3> kCoordinates{"x", "y", "z"};

bool is_coordinate(const Token& token) {
  return token.is(Keyword::x) || token.is(Keyword::y) || token.is(Keyword::z) || token.is(Keyword::u) ||
         token.is(Keyword::v);
}

/// `(a, b, c)`; none means x, y and z.
std::vector<std::string_view> parse_parameters(Reader& reader) {
  std::vector<std::string_view> names;
  if (!reader.accept(Punctuation::left_paren)) return {kCoordinates.begin(), kCoordinates.end()};
  do {
    const Token& name = reader.take();
    if (name.kind != TokenKind::identifier && !is_coordinate(name)) {
      reader.fail(name, "expected the name of a parameter, found " + describe(name));
    }
    if (names.size() == render::Function::kMostParameters) reader.fail(name, "the function has too many parameters");
    names.push_back(name.text);
    reader.skip_comma();
  } while (!reader.next_is(Punctuation::right_paren));
  reader.take();
  return names;
}

FunctionName meaning_of(const Value* value) {
  FunctionName name;
  if (value == nullptr) return name;
  if (const auto* numbers = std::get_if<Numbers>(value)) {
    name.values = numbers->values;
    name.size = numbers->size;
  } else if (const auto* function = std::get_if<render::FunctionPtr>(value)) {
    name.function = *function;
  }
  return name;
}

/// The tokens up to the block's `}`, with what their names stand for.
struct Body {
  std::vector<Token> tokens;
  std::vector<FunctionName> names;
};

Body collect(Reader& reader, const Token& word, std::span<const std::string_view> parameters) {
  Body body;
  Interpreter& in = reader.interpreter();
  while (!reader.next_is(Punctuation::right_brace)) {
    const Token& token = reader.peek();
    if (token.is_end()) break;
    if (body.tokens.size() == kMostBodyTokens) reader.fail(word, "the function is too large");
    FunctionName name;
    if (token.kind == TokenKind::identifier && std::ranges::find(parameters, token.text) == parameters.end()) {
      name = meaning_of(in.peek_value());
    }
    body.tokens.push_back(token);
    body.names.push_back(std::move(name));
    reader.take();
  }
  Token end = reader.peek();
  end.kind = TokenKind::end;
  body.tokens.push_back(end);
  return body;
}

render::FunctionPtr parse_expression(Reader& reader, const Token& word, std::span<const std::string_view> parameters) {
  const Body body = collect(reader, word, parameters);
  FunctionScope scope;
  scope.parameters = parameters;
  scope.names = body.names;
  scope.has_coordinates = true;
  scope.clock = reader.interpreter().options().clock;
  try {
    return compile_function(body.tokens, scope);
  } catch (const FunctionError& error) {
    try {
      reader.interpreter().fail(error.at, error.message);
    } catch (SyntaxError& mistake) {
      mistake.undeclared = error.unknown;
      throw;
    }
  }
}

render::FunctionPtr parse_internal(Reader& reader, const Token& word) {
  Interpreter& in = reader.interpreter();
  in.expect(Punctuation::left_paren, "after", word.text);
  const double number = reader.number();
  in.expect(Punctuation::right_paren, "to close", word.text);
  const bool whole = number >= 0.0 && number < 1000.0;
  render::FunctionPtr function = whole ? render::make_internal(static_cast<std::size_t>(number)) : nullptr;
  if (!function) reader.fail(word, "there is no internal function of this number");
  return function;
}

/// The scene's settings for patterns so far.
render::PatternWorld pattern_world(Reader& reader, const SceneContext& context) {
  return {reader.interpreter().language().noise_generator(), context.builder.settings().number_of_waves};
}

/// Parses what may stand in a function's block instead of an expression. Null: none of it.
render::FunctionPtr parse_special(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  if (word.kind != TokenKind::keyword) return nullptr;
  switch (word.keyword) {
    case Keyword::internal:
      reader.take();
      return parse_internal(reader, word);
    case Keyword::transform:
      reader.take();
      return render::make_transform_function(parse_transform(reader, word));
    case Keyword::spline: {
      reader.take();
      const auto spline = parse_spline(reader, word);
      return render::make_spline_function(spline);
    }
    case Keyword::pattern:
      reader.take();
      return render::make_pattern_function(parse_pigment(reader, context, word, render::Pigment()).pattern,
                                           pattern_world(reader, context));
    case Keyword::pigment:
      reader.take();
      return render::make_pigment_function(parse_pigment(reader, context, word, render::Pigment()),
                                           pattern_world(reader, context));
    default:
      return nullptr;
  }
}

}  // namespace

render::FunctionPtr parse_function(Reader& reader, SceneContext& context, const Token& word) {
  const bool has_list = reader.next_is(Punctuation::left_paren);
  const std::vector<std::string_view> parameters = parse_parameters(reader);
  reader.open_block(word);
  const Token& first = reader.peek();
  render::FunctionPtr function = parse_special(reader, context);
  if (!function) {
    function = parse_expression(reader, word, parameters);
  } else if (has_list && !first.is(Keyword::internal)) {
    reader.fail(first, "a function of a " + quoted(first) + " has no list of parameters");
  }
  reader.close_block();
  return function;
}

render::FunctionPtr parse_function_block(Reader& reader, const Token& word) {
  reader.open_block(word);
  render::FunctionPtr function = parse_expression(reader, word, kCoordinates);
  reader.close_block();
  return function;
}

}  // namespace firstlight::parser
