#include "parser/text/lexer.h"

#include "parser/text/syntax_error.h"

#include <charconv>
#include <limits>

namespace firstlight::parser {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r') || c == '\x1a'; }  // 0x1a ended DOS files

}  // namespace

/// The reading of one file.
class Lexer::Pass {
 public:
  Pass(const SourceFile& source, Symbols& symbols) : source_(source), text_(source.text), symbols_(symbols) {
    refuse_binary();
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > 127) ++at_;  // byte-order mark
  }
  Pass(const SourceFile& source, Symbols& symbols, Place begin)
      : source_(source), text_(source.text), symbols_(symbols), at_(begin.offset), line_(begin.line) {}

  Place place_of_token() const { return {static_cast<std::uint32_t>(start_), token_.location.line}; }

  const Token& next_token(bool in_outline) {
    in_outline_ = in_outline;
    if (skip_blanks()) {
      read_token();
    } else {
      begin_token();
      finish_token(TokenKind::end);
    }
    return token_;
  }

 private:
  char current() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  char next() const { return at_ + 1 < text_.size() ? text_[at_ + 1] : '\0'; }

  Location place(std::size_t from, std::size_t length) const {
    Location where;
    where.file = source_.index;
    where.line = line_;
    where.column = static_cast<std::uint32_t>(from - source_.line_starts[line_ - 1] + 1);
    where.length = static_cast<std::uint32_t>(length);
    return where;
  }

  [[noreturn]] void fail(const Location& where, std::string message) const {
    throw SyntaxError({diagnostic_at(source_, where, render::Diagnostic::Severity::error, std::move(message))});
  }

  void refuse_binary() const {
    if (text_.find('\0') == std::string_view::npos) return;
    Location whole_file;
    whole_file.file = source_.index;
    fail(whole_file, "expected scene text, found a binary file");
  }

  void advance() {
    ++at_;
    if (line_ < source_.line_starts.size() && at_ == source_.line_starts[line_]) ++line_;
  }

  // To the next token; false at the end of the text.
  bool skip_blanks() {
    while (at_ < text_.size()) {
      if (is_space(current())) {
        advance();
      } else if (current() == '/' && next() == '/') {
        const std::uint32_t line = line_;
        while (at_ < text_.size() && line_ == line) advance();
      } else if (current() == '/' && next() == '*') {
        skip_comment();
      } else {
        return true;
      }
    }
    return false;
  }

  void skip_comment() {
    const Location opening = place(at_, 2);
    int depth = 0;
    do {
      if (at_ >= text_.size()) fail(opening, "expected '*/' to close the comment, found end of file");
      if (current() == '/' && next() == '*') {
        ++depth;
        advance();
      } else if (current() == '*' && next() == '/') {
        --depth;
        advance();
      }
      advance();
    } while (depth > 0);
  }

  void begin_token() {
    start_ = at_;
    token_ = Token();
    token_.location = place(at_, 0);
  }

  void finish_token(TokenKind kind) {
    token_.kind = kind;
    token_.location.length = static_cast<std::uint32_t>(at_ - start_);
    if (kind != TokenKind::string) token_.text = text_.substr(start_, at_ - start_);
  }

  void read_token() {
    begin_token();
    const char c = current();
    if (is_digit(c) || (c == '.' && is_digit(next()))) {
      read_number();
    } else if (is_word_start(c)) {
      read_word();
    } else if (c == '"') {
      read_string();
    } else {
      read_mark();
    }
  }

  void read_number() {
    while (is_digit(current())) ++at_;
    if (current() == '.') {
      ++at_;
      while (is_digit(current())) ++at_;
    }
    std::size_t digits_end = at_;
    if (current() == 'e' || current() == 'E') {  // POV-Ray takes the letter for part of the number even without digits
      ++at_;
      if (current() == '+' || current() == '-') ++at_;
      const std::size_t exponent = at_;
      while (is_digit(current())) ++at_;
      if (at_ > exponent) digits_end = at_;
    }
    if (current() == '.') fail(place(start_, at_ - start_ + 1), "expected a number, found one with a second '.'");
    if (in_outline_) return finish_token(TokenKind::number);
    const char* first = text_.data() + start_;
    const auto result = std::from_chars(first, text_.data() + digits_end, token_.number);
    if (result.ec == std::errc::result_out_of_range) {
      const std::string_view digits(first, digits_end - start_);
      const bool tiny = digits.find("e-") != std::string_view::npos || digits.find("E-") != std::string_view::npos;
      token_.number = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    finish_token(TokenKind::number);
  }

  void read_word() {
    while (is_word_start(current()) || is_digit(current())) ++at_;
    const std::string_view word = text_.substr(start_, at_ - start_);
    token_.keyword = find_keyword(word);
    if (token_.keyword == Keyword::none) token_.symbol = symbols_.intern(word);
    finish_token(token_.keyword == Keyword::none ? TokenKind::identifier : TokenKind::keyword);
  }

  void read_string() {
    const Location opening = place(at_, 1);
    advance();
    const std::size_t contents = at_;
    while (current() != '"' || at_ >= text_.size()) {
      if (current() == '\\') advance();
      if (at_ >= text_.size()) fail(opening, "expected '\"' to end the string, found end of file");
      advance();
    }
    token_.text = text_.substr(contents, at_ - contents);
    ++at_;
    finish_token(TokenKind::string);
    if (opening.line != line_) token_.location.length = 1;  // a string of several lines: underline its quote
  }

  void read_mark() {
    using enum Punctuation;
    static constexpr std::string_view kMarks = "{}()[]<>=+-*/|&!?:;,.#@`\\$^%'~";
    static constexpr Punctuation kMeanings[] = {
        left_brace, right_brace, left_paren, right_paren, left_bracket, right_bracket, less,      greater,
        equal,      plus,        dash,       star,        slash,        bar,           ampersand, exclamation,
        question,   colon,       semicolon,  comma,       period,       hash,          at,        backquote,
        backslash,  dollar,      hat,        percent,     quote,        tilde};
    const char c = current();
    const std::size_t found = kMarks.find(c);
    if (found == std::string_view::npos) {
      constexpr std::string_view kHex = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(c);
      fail(place(at_, 1), std::string("expected scene text, found a character that is not allowed here (byte 0x") +
                              kHex[byte >> 4] + kHex[byte & 15] + ")");
    }
    token_.punctuation = kMeanings[found];
    ++at_;
    if (current() == '=' && (c == '<' || c == '>' || c == '!')) {
      token_.punctuation = c == '<' ? less_equal : c == '>' ? greater_equal : not_equal;
      ++at_;
    }
    finish_token(TokenKind::punctuation);
  }

  const SourceFile& source_;
  std::string_view text_;
  Symbols& symbols_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;
  std::uint32_t line_ = 1;
  bool in_outline_ = false;
  Token token_;
};

Lexer::Lexer(const SourceFile& source, Symbols& symbols) : pass_(std::make_unique<Pass>(source, symbols)) {}
Lexer::Lexer(const SourceFile& source, Symbols& symbols, Place begin)
    : pass_(std::make_unique<Pass>(source, symbols, begin)) {}
Lexer::~Lexer() = default;
Token Lexer::next() { return pass_->next_token(false); }
Token Lexer::next_in_outline() { return pass_->next_token(true); }
Lexer::Place Lexer::place() const { return pass_->place_of_token(); }

std::uint32_t Symbols::intern(std::string_view name) {
  const auto found = table_.find(name);
  if (found != table_.end()) return found->second;
  const auto symbol = static_cast<std::uint32_t>(names_.size());
  names_.emplace_back(name);
  table_.emplace(names_.back(), symbol);
  return symbol;
}

}  // namespace firstlight::parser
