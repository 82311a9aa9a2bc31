#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::priority {

/// A mistake in the text of a scheme, and its place. Thrown inside the folder, caught by Order::parse.
struct SchemeError {
  std::size_t at = 0;  ///< bytes before the place
  std::size_t length = 1;
  std::string message;
};

/// A scheme that cannot be without arguments has none; `what` they should be. Thrown by its maker.
struct MissingArguments {
  std::string what;
};

/// A piece of the text of a scheme.
struct Piece {
  std::string_view text;
  std::size_t at = 0;
};

/// Reads the text of a scheme piece by piece. All members pass over blanks first.
class SchemeText {
 public:
  explicit SchemeText(std::string_view text) : text_(text) {}

  bool at_end();
  bool next_is(char mark);
  bool at_word();
  bool at_number();
  bool accept(char mark);
  /// Takes `mark`, or fails with "expected ')' `purpose`, found ...".
  void expect(char mark, std::string_view purpose);
  /// The name of a scheme: letters, digits, and hyphens within. Of "level-sample" it is the longest part that is in
  /// `known`, or all of it when none is.
  Piece name(std::span<const std::string_view> known);
  /// An identifier of the scene language.
  Piece identifier(std::string_view what);
  /// Unsigned.
  double number(std::string_view what);
  int integer(std::string_view what);
  /// All up to the parenthesis that closes the one taken last.
  Piece rest_of_parenthesis();
  /// The piece that comes next, not taken: for messages.
  Piece next();

  [[noreturn]] void fail(const Piece& where, std::string message) const;
  [[noreturn]] void fail_expected(std::string_view what);

 private:
  void skip_blanks();

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The order that a user wants some words in.
struct Ranks {
  std::vector<std::uint32_t> of;  ///< the place of each word, from 0; those not named come behind the others
  std::uint32_t named = 0;
};
/// A list of some of `words`, of which each may be named once, as in `ray-type(reflection shadow)`.
Ranks read_ranks(SchemeText& text, std::string_view what, std::span<const std::string_view> words);

/// " (the nearest is 'contribution')", or nothing when none of `known` is near.
std::string nearest_hint(std::string_view word, std::span<const std::string_view> known);

/// The message, the text, and a caret under the place.
std::string format(const SchemeError& error, std::string_view text);

}  // namespace firstlight::priority
