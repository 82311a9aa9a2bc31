#pragma once

#include "parser/text/token.h"
#include "parser/text/token_stream.h"
#include "parser/text/value.h"
#include "render/math/color.h"
#include "render/math/vec.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace firstlight::parser {

class Interpreter;  // directives, macros, scopes, files: parser/directive/interpreter.h

/// The scene text as the statements of the language see it: a stream of significant tokens, with directives already
/// obeyed and macros replayed, and the expressions that may stand where a number, vector, colour or string is due.
///
/// Errors   A mistake is thrown as SyntaxError inside the folder; parse_file() turns it into diagnostics.
class Reader {
 public:
  explicit Reader(Interpreter& interpreter);

  // --- tokens -------------------------------------------------------------------------------------------------------
  Token peek() { return stream_.peek(); }
  Token take() { return stream_.take(); }
  bool next_is(Keyword word) { return peek().is(word); }
  bool next_is(Punctuation mark) { return peek().is(mark); }
  /// Takes the next token if it is the one named.
  bool accept(Keyword word) { return accept_if(next_is(word)); }
  bool accept(Punctuation mark) { return accept_if(next_is(mark)); }
  /// POV-Ray's commas between arguments are optional.
  void skip_comma() { accept(Punctuation::comma); }
  /// Takes `{` of a block opened by `owner`, and remembers the place for the message about a missing `}`.
  void open_block(const Token& owner) { stream_.open_block(owner); }
  void close_block() { stream_.close_block(); }

  // --- declared values ----------------------------------------------------------------------------------------------
  /// If the next token is an identifier (or array element) holding a T, takes it and returns the value; else null, and
  /// nothing is taken. T is one of the alternatives of Value behind a shared_ptr, e.g.
  /// accept_declared<render::Texture>().
  template <class T>
  std::shared_ptr<const T> accept_declared();

  // --- expressions
  // ----------------------------------------------------------------------------------------------------
  /// Whether the next token can begin a numeric, vector or colour expression (CASE_EXPRESS in POV-Ray's terms), or a
  /// number only.
  bool at_expression();
  bool at_number();
  double number();
  /// A number is promoted to a vector with equal components.
  render::Vec3 vector3();
  render::Vec2 vector2();
  /// Any colour expression, with or without a leading `color` / `rgb...` word, or a declared colour; a number is grey
  /// in all five components' rgb.
  render::FilteredColor color();
  /// The number after a keyword that may stand alone: `metallic`, `fresnel off`, `open`.
  double optional_number(double when_absent);
  bool optional_flag(bool when_absent = true);
  std::string string();
  Numbers expression();

  // --- messages
  // -------------------------------------------------------------------------------------------------------
  [[noreturn]] void fail(const Token& at, std::string message);
  /// The same about a limit, behind which the scene is not read on.
  [[noreturn]] void fail_finally(const Token& at, std::string message);
  /// "expected `what`, found ..." at the next token.
  [[noreturn]] void fail_expected(std::string_view what);
  void warn(const Token& at, std::string message);

  Interpreter& interpreter() { return interpreter_; }

 private:
  bool accept_if(bool is_next) {
    if (is_next) stream_.take();
    return is_next;
  }
  Interpreter& interpreter_;
  TokenStream& stream_;  // the same
};

template <class T>
std::shared_ptr<const T> Reader::accept_declared() {
  const Value* value = stream_.peek_value();
  if (value == nullptr) return nullptr;
  const auto* held = std::get_if<std::shared_ptr<const T>>(value);
  if (held == nullptr) return nullptr;
  std::shared_ptr<const T> result = *held;
  stream_.take_binding();
  return result;
}

}  // namespace firstlight::parser
