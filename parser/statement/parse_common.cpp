#include "parser/statement/parse_common.h"

#include "parser/directive/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace firstlight::parser {

std::string quoted(const Token& word) { return fmt::format("'{}'", word.text); }

render::FeatureUse feature_use(render::Feature feature, const Token& word) {
  return {feature, word.location.file, word.location.line, word.location.column};
}

int language_version(Reader& reader) { return reader.interpreter().language_version(); }

int effective_language_version(Reader& reader) { return reader.interpreter().effective_language_version(); }

bool at_color(Reader& reader) {
  const Token& next = reader.peek();
  if (next.kind == TokenKind::identifier) {
    const Value* value = reader.interpreter().peek_value();
    const auto* numbers = value ? std::get_if<Numbers>(value) : nullptr;
    return numbers && (numbers->is_color || numbers->size == 5);
  }
  if (next.kind != TokenKind::keyword) return false;
  switch (next.keyword) {
    case Keyword::color:
    case Keyword::rgb:
    case Keyword::rgbf:
    case Keyword::rgbt:
    case Keyword::rgbft:
    case Keyword::srgb:
    case Keyword::srgbf:
    case Keyword::srgbt:
    case Keyword::srgbft:
    case Keyword::red:
    case Keyword::green:
    case Keyword::blue:
    case Keyword::filter:
    case Keyword::transmit:
    case Keyword::alpha:
      return true;
    default:
      return false;
  }
}

render::FilteredColor color_or_black(Reader& reader) {
  if (reader.at_expression()) return reader.color();
  reader.warn(reader.peek(), "expected a colour, found none; it is taken as black");
  return {};
}

double finite(Reader& reader, const Token& at, double value, std::string_view what) {
  if (!std::isfinite(value)) reader.fail(at, std::string(what) + " is not a finite number");
  return value;
}

bool is_finite(const render::Vec3& value) {
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

render::Vec3 finite(Reader& reader, const Token& at, const render::Vec3& value, std::string_view what) {
  if (!is_finite(value)) {
    reader.fail(at, std::string(what) + " has a component that is not a finite number");
  }
  return value;
}

double finite_number(Reader& reader, std::string_view what) {
  const Token& at = reader.peek();
  return finite(reader, at, reader.number(), what);
}

render::Vec3 finite_vector(Reader& reader, std::string_view what) {
  const Token& at = reader.peek();
  return finite(reader, at, reader.vector3(), what);
}

int integer(Reader& reader, std::string_view what, int low, int high) {
  return static_cast<int>(
      std::clamp(std::trunc(finite_number(reader, what)), static_cast<double>(low), static_cast<double>(high)));
}

void skip_block(Reader& reader, const Token& owner) {
  reader.open_block(owner);
  for (int depth = 0; depth > 0 || !reader.next_is(Punctuation::right_brace);) {
    const Token& next = reader.take();
    if (next.is_end()) reader.fail(owner, "no '}' closes " + quoted(owner));
    if (next.is(Punctuation::left_brace)) ++depth;
    if (next.is(Punctuation::right_brace)) --depth;
  }
  reader.close_block();
}

}  // namespace firstlight::parser
