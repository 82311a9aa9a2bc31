// After a mistake: where reading goes on, and which further mistakes are only its consequences.
#include "parser/directive/recovery.h"

#include "parser/directive/interpreter.h"

#include <algorithm>
#include <utility>

namespace firstlight::parser {

using render::Diagnostic;

namespace {

constexpr std::size_t kShortestStandardName = 3;  // shorter ones are anybody's

bool goes_on_with_block(Keyword word) {
  return word == Keyword::else_ || word == Keyword::elseif || word == Keyword::case_ || word == Keyword::range;
}

}  // namespace

bool Recovery::is_consequence(const SyntaxError& error) const {
  if (mistakes_ == 0) return false;
  if (error.unbalanced) return true;
  if (error.undeclared != kNoSymbol && (include_failed_ || broken_names_.contains(error.undeclared))) return true;
  const Diagnostic& at = error.diagnostics.front();
  return reported_places_.contains({at.file, at.line, at.column});
}

// Tells of a mistake after which the scene cannot be rendered but can be read further.
void Recovery::report(const SyntaxError& error) {
  if (!is_consequence(error)) {
    const Diagnostic& at = error.diagnostics.front();
    reported_places_.insert({at.file, at.line, at.column});
    render::Diagnostics messages = error.diagnostics;
    if (error.undeclared != kNoSymbol && in_.scopes().find(error.undeclared) == nullptr) {
      const std::string hint = standard_file_hint(in_.symbols().name(error.undeclared));
      std::string& message = messages.front().message;
      if (!hint.empty()) message = message.substr(0, message.find("; did you mean")) + hint;
    }
    for (const Diagnostic& message : messages) in_.report(message);
    if (++mistakes_ >= kMostMistakes) give_up();
  }
  if (error.undeclared != kNoSymbol) broken_names_.insert(error.undeclared);
  if (++failures_ >= kMostFailures) give_up();
}

std::string Recovery::standard_file_hint(std::string_view name) const {
  if (name.size() < kShortestStandardName) return {};
  const std::string file = in_.files().standard_file_with(name);
  if (file.empty()) return {};
  return "; '" + std::string(name) + "' is declared in the standard file '" + file + "', which is not included";
}

void Recovery::give_up() {
  Diagnostic last;
  last.severity = Diagnostic::Severity::note;
  last.file = in_.frames().front().file->source().name;
  last.message = "reading stops here, after " + std::to_string(mistakes_) + (mistakes_ == 1 ? " error" : " errors");
  SyntaxError error({last});
  error.fatal = true;
  throw error;
}

void Recovery::recover(const SyntaxError& error) {
  if (error.fatal || in_.frames().empty()) throw error;
  report(error);
  const TokenStream::StatementStart statement = in_.statement();
  in_.unsettle();
  std::set<std::pair<const TokenFile*, std::uint32_t>> noted;  // a macro that calls itself leaves many such frames
  while (in_.frames().size() > std::max<std::size_t>(statement.frames, 1)) {
    const Interpreter::Frame& frame = in_.frame();
    if (noted.emplace(frame.file, frame.position).second) note_broken_names(frame.position, frame.end);
    in_.leave_frame();
  }
  in_.drop_blocks();
  const bool same_frame = in_.frames().size() == statement.frames && statement.position <= in_.frame().position;
  const std::uint32_t reached = in_.frame().position;
  const std::uint32_t start = same_frame ? statement.position : reached;
  in_.conditions().forget_left();
  if (same_frame) in_.conditions().forget_since(start);
  // The end of a loop whose condition is wrong ends it.
  const bool at_end = same_frame && (*in_.frame().file)[start + 1].is(Keyword::end);
  if (at_end) in_.conditions().forget_innermost();
  in_.frame().position = next_statement(start, reached);
  note_broken_names(start, in_.frame().position);
}

// The first place behind `start`, not before `reached`, where a statement may begin: outside of all braces and blocks
// of directives that are open since `start`.
std::uint32_t Recovery::next_statement(std::uint32_t start, std::uint32_t reached) const {
  const TokenFile& tokens = *in_.frame().file;
  int depth = 0;
  std::vector<int> depths;  // where the open blocks of directives began
  for (std::uint32_t i = start; i < in_.frame().end; ++i) {
    const Token token = tokens[i];
    const bool outside = depth <= 0 && depths.empty();
    if (outside && i > start && i >= reached && may_begin_statement(i)) return i;
    if (token.is(Punctuation::left_brace)) ++depth;
    if (token.is(Punctuation::right_brace)) depth = std::max(depth - 1, 0);
    if (!token.is(Punctuation::hash)) continue;
    const Keyword word = tokens[i + 1].keyword;
    if (opens_block(word)) {
      depths.push_back(depth);
    } else if (goes_on_with_block(word) && !depths.empty()) {
      depth = depths.back();
    } else if (goes_on_with_block(word) && i < reached) {
      // A branch that was read to its end before the mistake: the others are none of the statement's text.
      const std::uint32_t end = end_of_block(*in_.frame().file, i);
      if (end != kNoLink) i = end + 1;
    } else if (word == Keyword::end && !depths.empty()) {
      depths.pop_back();
    }
  }
  return in_.frame().end;
}

bool Recovery::may_begin_statement(std::uint32_t index) const {
  const TokenFile& tokens = *in_.frame().file;
  const Token token = tokens[index];
  if (token.is(Punctuation::hash)) return true;
  const Token before = tokens[index - 1];
  const bool behind_end = before.is(Punctuation::semicolon) || before.is(Punctuation::right_brace) ||
                          (index > 1 && before.is(Keyword::end) && tokens[index - 2].is(Punctuation::hash));
  if (!behind_end && before.location.line == token.location.line) return false;
  // `word {`, but for the further layers of a texture that is declared.
  if (token.kind == TokenKind::keyword)
    return tokens[index + 1].is(Punctuation::left_brace) && !token.is(Keyword::texture);
  const Scopes::Binding* binding = token.kind == TokenKind::identifier ? in_.scopes().find(token.symbol) : nullptr;
  return binding != nullptr && std::holds_alternative<std::shared_ptr<const Macro>>(*binding->slot);
}

// Notes the names that the text would have declared and did not.
void Recovery::note_broken_names(std::uint32_t begin, std::uint32_t end) {
  const TokenFile& tokens = *in_.frame().file;
  for (std::uint32_t i = begin; i + 2 < end; ++i) {
    const Keyword word = tokens[i + 1].keyword;
    if (!tokens[i].is(Punctuation::hash)) continue;
    if (word == Keyword::include) include_failed_ = true;
    if (word != Keyword::declare && word != Keyword::local && word != Keyword::macro) continue;
    // The names of a tuple stand in brackets.
    for (std::uint32_t name = i + 2; name < end && !tokens[name].is(Punctuation::equal); ++name) {
      if (tokens[name].kind == TokenKind::identifier) broken_names_.insert(tokens[name].symbol);
      if (tokens[i + 2].kind == TokenKind::identifier || tokens[name].is(Punctuation::hash)) break;
    }
  }
}

}  // namespace firstlight::parser
