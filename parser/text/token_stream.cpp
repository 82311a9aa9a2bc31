#include "parser/text/token_stream.h"

#include "render/scene/nearest.h"

#include <utility>

namespace firstlight::parser {

using render::Diagnostic;

namespace {

constexpr std::size_t kShortestSuggestion = 3;    // shorter words are all alike
constexpr std::size_t kLongestCallChain = 8;      // calls a message tells of
constexpr std::size_t kMostDiagnostics = 10'000;  // kept of one scene; a loop may warn at every turn

bool stands_for_itself(const Token& token) {
  return token.kind != TokenKind::identifier && token.punctuation != Punctuation::hash &&
         token.keyword != Keyword::local && token.keyword != Keyword::global;
}

}  // namespace

void TokenStream::fail_nesting() {
  fail(raw_next().location, "expressions, declarations or macro arguments are nested too deeply here (limit " +
                                std::to_string(kDeepestExpression) + ")");
}

// --- tokens ---------------------------------------------------------------------------------------------------------

void TokenStream::settle() {
  if (pending_ && is_held()) return;
  unsettle();
  Frame& frame = frames_.back();
  const Token* const all = frame.file->all();
  if (all != nullptr && frame.position < frame.end) {
    const Token& token = all[frame.position];
    if (stands_for_itself(token)) return show_where_it_lies(token, frame.position++);
  }
  settle_step_by_step();
}

// Obeys, calls and looks up until something can be shown.
void TokenStream::settle_step_by_step() {
  for (;;) {
    Frame& frame = frames_.back();
    if (frame.position >= frame.end) {
      if (frames_.size() > 1) {
        leave_frame();
        continue;
      }
      return show(frame.file->view(frame.end), frame.end);
    }
    const Token& token = frame.file->view(frame.position);
    if (token.kind == TokenKind::identifier) {
      if (settle_name(token)) return;
      continue;
    }
    if (token.is(Punctuation::hash) && !is_held()) {
      note_statement(frame.position);
      const Nesting nesting(*this);
      run_directive();
      // Reading the directive may have shown the token behind it already.
      if (settled_ && !pending_) return;
      unsettle();
      continue;
    }
    if (!stands_for_itself(token) && is_prefix()) {
      if (settle_prefixed_name()) return;
      continue;
    }
    show(frame.file->view(frame.position), frame.position);  // anew, for is_prefix() has looked behind it
    ++frame.position;
    pending_ = next_->is(Punctuation::hash);
    return;
  }
}

// At a name where it lies. False when it was a macro's, which has been called.
bool TokenStream::settle_name(const Token& name) {
  Frame& frame = frames_.back();
  const std::uint32_t index = frame.position++;
  note_statement(index);
  const Scopes::Binding* const binding = scopes_.find(name.symbol);
  if (binding != nullptr && std::holds_alternative<Numbers>(*binding->slot) && deprecated_.empty()) {  // most of them
    show(name, index);
    next_value_ = binding->slot.get();
    next_scope_ = binding->scope;
    return true;
  }
  if (frame.file->all() != nullptr) return settle_as(name, index, binding, false);
  return settle_as(Token(name), index, binding, false);
}

bool TokenStream::settle_prefixed_name() {
  const std::uint32_t index = frames_.back().position;
  note_statement(index);
  const std::string prefix(raw_next().text);
  const Scopes::Reach reach = take_reach();
  const Token name = take_prefixed(reach);
  if (name.kind != TokenKind::identifier) {
    fail(name.location, "expected an identifier behind '" + prefix + ".', found " + describe(name));
  }
  return settle_as(name, index, scopes_.find(name.symbol, reach), true);
}

bool TokenStream::settle_as(const Token& name, std::uint32_t index, const Scopes::Binding* binding, bool prefixed) {
  const Value* value = nullptr;
  bool is_macro = false;
  if (binding != nullptr) {
    next_scope_ = binding->scope;
    if (!deprecated_.empty()) warn_of_deprecated(name);
    value = binding->slot.get();
    if (const auto* macro = std::get_if<std::shared_ptr<const Macro>>(value)) {
      is_macro = true;
      if (!is_held()) {
        call_macro(name, *macro);
        return false;
      }
    } else if (picks_part(*value, raw_next())) {
      next_element_ = pick_part(Scopes::Slot(binding->slot), name, Pick::value);
      value = next_element_.get();
    } else if (prefixed) {
      next_element_ = binding->slot;
    }
  }
  next_ = &(shown_ = name);
  next_index_ = index;
  next_value_ = value;
  pending_ = is_macro;
  settled_ = true;
  return true;
}

void TokenStream::warn_of_deprecated(const Token& name) {
  const auto found = deprecated_.find(name.symbol);
  if (found == deprecated_.end()) return;
  warn(name.location, found->second.message);
  if (found->second.once) deprecated_.erase(found);
}

std::map<std::string, std::uint64_t> TokenStream::keyword_counts() const {
  std::map<std::string, std::uint64_t> counts;
  for (std::size_t i = 1; i < kKeywordCount; ++i) {
    if (keyword_counts_[i] > 0) counts.emplace(spelling(static_cast<Keyword>(i)), keyword_counts_[i]);
  }
  return counts;
}

Scopes::Binding TokenStream::peek_binding() const {
  if (next_element_ != nullptr && next_element_.get() == next_value_) return {next_scope_, next_element_};
  const Scopes::Binding* binding = scopes_.find(next_->symbol);
  return binding != nullptr ? *binding : Scopes::Binding();
}

Scopes::Binding TokenStream::take_binding() {
  peek();
  const Scopes::Binding result = peek_binding();
  settled_ = false;
  pending_ = false;
  last_ = next_->location;
  ++taken_;
  return result;
}

bool TokenStream::next_is_word(std::string_view word) {
  return peek().kind == TokenKind::identifier && next_value_ == nullptr && next_->text == word;
}

bool TokenStream::accept_word(std::string_view word) {
  if (!next_is_word(word)) return false;
  take_binding();
  return true;
}

Token TokenStream::take_raw() {
  Frame& frame = frames_.back();
  const Token token = frame.file->view(frame.position);
  if (frame.position < frame.end) ++frame.position;
  return token;
}

// `local` or `global` before `.Name` or `["Name"]`. There is a token behind it, for the last one is the file's end.
bool TokenStream::is_prefix() const {
  const Keyword word = raw_next().keyword;
  if (word != Keyword::local && word != Keyword::global) return false;
  const Token behind = frames_.back().file->view(frames_.back().position + 1);
  return behind.is(Punctuation::period) || behind.is(Punctuation::left_bracket);
}

Scopes::Reach TokenStream::take_reach() {
  if (!is_prefix()) return Scopes::Reach::any;
  const Keyword word = take_raw().keyword;
  count(word);
  if (raw_next().is(Punctuation::period)) ++frames_.back().position;
  return word == Keyword::local ? Scopes::Reach::local : Scopes::Reach::global;
}

Token TokenStream::take_prefixed(Scopes::Reach reach) {
  if (reach == Scopes::Reach::any || !raw_next().is(Punctuation::left_bracket)) return take_raw();
  constexpr std::size_t kMostNames = 1'000'000;
  const Token bracket = raw_next();
  const std::uint32_t index = frames_.back().position;
  const Nesting nesting(*this);
  const std::uint32_t symbol = symbols_.intern(parse_key());
  unsettle();
  named_by_strings_.insert({bracket.location.file, index, symbol});
  if (named_by_strings_.size() > kMostNames) {
    fail_finally(bracket.location, "too many names are given as strings (limit " + std::to_string(kMostNames) + ")");
  }
  Token name;
  name.kind = TokenKind::identifier;
  name.symbol = symbol;
  name.text = symbols_.name(symbol);
  name.location = bracket.location;
  return name;
}

void TokenStream::fail_expected(Punctuation mark, std::string_view purpose, std::string_view name) {
  std::string expected = "expected '" + std::string(spelling(mark)) + "' " + std::string(purpose);
  if (!name.empty()) expected.append(" '").append(name).append("'");
  fail(peek().location, expected + ", found " + describe_next());
}

// --- frames ---------------------------------------------------------------------------------------------------------

void TokenStream::enter_frame(Frame frame) {
  unsettle();
  if (frames_.size() >= kDeepestFrame) {
    fail_finally(frame.call,
                 "macros and included files are nested too deeply here (limit " + std::to_string(kDeepestFrame) + ")");
  }
  if (!frames_.empty()) scopes_.enter();
  frames_.push_back(std::move(frame));
}

void TokenStream::leave_frame() {
  frames_.pop_back();
  scopes_.leave();
}

// --- blocks ---------------------------------------------------------------------------------------------------------

void TokenStream::fail_block(const Token& owner) {
  if (!peek().is(Punctuation::left_brace)) {
    fail(peek().location, "expected '{' after '" + std::string(owner.text) + "', found " + describe_next());
  }
  fail(owner.location, "blocks are nested too deeply here (limit " + std::to_string(kDeepestBlock) + ")");
}

void TokenStream::fail_unclosed_block() {
  const Token& owner = blocks_.back();
  const std::string name(owner.text);
  fail(peek().location, "expected '}' to close '" + name + "', found " + describe_next(), owner.location,
       "'" + name + "' opened here");
}

// --- messages -------------------------------------------------------------------------------------------------------

std::string TokenStream::describe_next() {
  const Token& token = peek();
  if (token.kind != TokenKind::identifier) return describe(token);
  if (next_value_ == nullptr) {
    described_undeclared_ = token.symbol;
    return "undeclared identifier '" + std::string(token.text) + "'" + suggestion(token.text);
  }
  return std::string(kind_name(*next_value_)) + " '" + std::string(token.text) + "'";
}

std::string TokenStream::suggestion(std::string_view word) const {
  if (word.size() < kShortestSuggestion) return {};
  std::vector<std::string> known = scopes_.declared_names(symbols_);
  for (std::size_t i = 1; i < kKeywordCount; ++i) known.emplace_back(spelling(static_cast<Keyword>(i)));
  const std::string near = render::nearest(word, known);
  return near.empty() || near == word ? std::string() : "; did you mean '" + near + "'?";
}

void TokenStream::begin_statement() {
  peek();
  note_statement(next_index_);
}

Location TokenStream::behind_last_token() const {
  Location place = last_;
  place.column += place.length;
  place.length = 1;
  return place;
}

Diagnostic TokenStream::diagnostic(const Location& at, Diagnostic::Severity severity, std::string message) const {
  return diagnostic_at(files_.file(at.file), at, severity, std::move(message));
}

Diagnostic TokenStream::describe_unrendered(const render::FeatureUse& use) const {
  const auto word = static_cast<std::uint32_t>(render::spelling(use.feature).size());
  const std::string name(render::spelling(use.feature));
  Diagnostic result = diagnostic({use.file, use.line, use.column, word}, Diagnostic::Severity::error,
                                 "'" + name + "' cannot be rendered by this version of Firstlight");
  result.subject = name;
  return result;
}

SyntaxError TokenStream::error_at(const Location& at, std::string message) {
  SyntaxError error({diagnostic(at, Diagnostic::Severity::error, std::move(message))});
  error.undeclared = std::exchange(described_undeclared_, kNoSymbol);
  return error;
}

void TokenStream::fail(const Location& at, std::string message) {
  SyntaxError error = error_at(at, std::move(message));
  add_call_chain(error.diagnostics);
  throw error;
}

void TokenStream::fail(const Location& at, std::string message, const Location& note_at, std::string note) {
  SyntaxError error = error_at(at, std::move(message));
  error.diagnostics.push_back(diagnostic(note_at, Diagnostic::Severity::note, std::move(note)));
  add_call_chain(error.diagnostics);
  throw error;
}

void TokenStream::fail_finally(const Location& at, std::string message) {
  SyntaxError error = error_at(at, std::move(message));
  error.fatal = true;
  add_call_chain(error.diagnostics);
  throw error;
}

void TokenStream::fail_unbalanced(const Location& at, std::string message) {
  SyntaxError error = error_at(at, std::move(message));
  error.unbalanced = true;
  add_call_chain(error.diagnostics);
  throw error;
}

void TokenStream::add_call_chain(render::Diagnostics& messages) const {
  std::size_t told = 0;
  for (std::size_t i = frames_.size(); i-- > 1 && told < kLongestCallChain; ++told) {
    const Frame& frame = frames_[i];
    messages.push_back(diagnostic(frame.call, Diagnostic::Severity::note,
                                  frame.macro ? "in macro '" + std::string(frame.macro->name) + "', called from here"
                                              : "in '" + frame.file->source().name + "', included from here"));
  }
}

void TokenStream::report(const Location& at, std::string message, Diagnostic::Severity severity) {
  described_undeclared_ = kNoSymbol;
  if (diagnostics_.size() > kMostDiagnostics) return;
  if (diagnostics_.size() == kMostDiagnostics) message = "further messages are left out";
  report(diagnostic(at, severity, std::move(message)));
}

void TokenStream::report(const Diagnostic& message) {
  diagnostics_.push_back(message);
  if (options_.report) options_.report(message);
}

}  // namespace firstlight::parser
