#include "parser/directive/data_file.h"
#include "parser/directive/declarable.h"
#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"
#include "parser/expression/expression.h"
#include "parser/expression/string_expression.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

namespace firstlight::parser {

using render::Diagnostic;

namespace {

bool parse_predefined(const std::string& text, Numbers& number) {
  Symbols none;
  SourceFile source;
  source.text = text;
  source.line_starts = {0};
  const std::size_t start = !text.empty() && text[0] == '-' ? 1 : 0;
  source.text = text.substr(start);
  try {
    const TokenFile file(source, none);
    if (file.size() != 2 || file[0].kind != TokenKind::number) return false;
    number.values[0] = start == 1 ? -file[0].number : file[0].number;
  } catch (const SyntaxError&) {
    return false;
  }
  return true;
}

Value make_number(double value) {
  Numbers number;
  number.values[0] = value;
  return number;
}

}  // namespace

Interpreter::Interpreter(const render::LoadOptions& options, render::Diagnostics& diagnostics, SceneContext& context)
    : Evaluator(options, diagnostics, context.builder), context_(context) {
  const auto declare = [this](std::string_view name, Value value) {
    *scopes().target(symbols().intern(name), false) = std::move(value);
  };
  declare("image_width", make_number(options.width));
  declare("image_height", make_number(options.height));
  // A still picture is no frame of an animation: POV-Ray gives 0 for all of these.
  for (const char* name :
       {"frame_number", "initial_frame", "final_frame", "initial_clock", "final_clock", "clock_delta"}) {
    declare(name, make_number(0.0));
  }
  for (const auto& [name, text] : options.declares) {
    Numbers number;
    if (parse_predefined(text, number)) {
      declare(name, number);
    } else {
      const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
      declare(name, quoted ? text.substr(1, text.size() - 2) : text);
    }
  }
}

void Interpreter::count_step(const Location& at) {
  note_replay();
  if (++steps_ > kMostSteps) {
    fail_finally(at, "this scene turns in loops or macros without end (limit " + std::to_string(kMostSteps) +
                         " turns and calls)");
  }
}

void Interpreter::call_macro(const Token& name, std::shared_ptr<const Macro> macro) {
  macros_.call(name, std::move(macro));
}

Scopes::Slot Interpreter::pick_part(const Scopes::Slot& container, const Token& name, Pick purpose) {
  return containers_.pick_part(container, name, purpose);
}

std::string Interpreter::parse_key() { return containers_.parse_key(); }

void Interpreter::run_directive() {
  Frame& text = frame();
  const std::uint32_t hash = text.position;
  const Token* const all = text.file->all();
  text.position = std::min(hash + 2, text.end);
  if (all != nullptr) return obey(all[hash + 1], hash);
  obey((*text.file)[hash + 1], hash);
}

void Interpreter::obey(const Token& word, std::uint32_t hash) {
  count(word.keyword);
  switch (word.keyword) {
    case Keyword::declare:
    case Keyword::local:
      return declarations_.run_declare(word, true);
    case Keyword::undef:
      return run_undef(word);
    case Keyword::if_:
    case Keyword::ifdef:
    case Keyword::ifndef:
      return conditions_.run_if(word, hash);
    case Keyword::else_:
    case Keyword::elseif:
    case Keyword::case_:
    case Keyword::range:
      return conditions_.run_further_branch(word, hash);
    case Keyword::switch_:
      return conditions_.run_switch(word, hash);
    case Keyword::while_:
      return conditions_.run_while(word, hash);
    case Keyword::for_:
      return conditions_.run_for(word, hash);
    case Keyword::end:
      return conditions_.run_end(word, hash);
    case Keyword::break_:
      return conditions_.run_break(word);
    case Keyword::macro:
      return macros_.define(word, hash);
    case Keyword::include:
      return run_include(word);
    case Keyword::version:
      return run_version(word, hash == 0 && frames().size() == 1);
    case Keyword::default_: {
      Reader reader(*this);
      return parse_default(reader, context_);
    }
    case Keyword::debug:
    case Keyword::warning:
    case Keyword::error:
    case Keyword::render:
    case Keyword::statistics:
      return run_message(word);
    case Keyword::fopen:
      return data_files_.run_fopen(word);
    case Keyword::fclose:
      return data_files_.run_fclose(word);
    case Keyword::read:
      return data_files_.run_read(word);
    case Keyword::write:
      return data_files_.run_write(word);
    default:
      break;
  }
  const bool undeclared = word.kind == TokenKind::identifier && scopes().find(word.symbol) == nullptr;
  if (undeclared || word.is_end()) {
    fail(word.location, "expected a directive after '#', found " + describe(word) + suggestion(word.text));
  }
  // POV-Ray passes over a '#' that begins no directive.
  warn(word.location, "expected a directive after '#', found " + describe(word) + "; the '#' is ignored");
  frame().position = hash + 1;
}

void Interpreter::run_bare_directive() {
  const Token& word = take();
  warn(word.location, "'" + std::string(word.text) + "' should be written '#" + std::string(word.text) + "'");
  const Nesting nesting(*this);
  switch (word.keyword) {
    case Keyword::declare:
      return declarations_.run_declare(word, false);
    case Keyword::include:
      return run_include(word);
    case Keyword::version:
      return run_version(word, false);
    default:
      fail(word.location, "expected a directive, found " + describe(word));
  }
}

void Interpreter::run_message(const Token& word) {
  if (word.is(Keyword::render) || word.is(Keyword::statistics)) {
    warn(word.location, "'#" + std::string(word.text) + "' writes where '#debug' does");
  }
  std::string text = parse_string(*this);
  const bool debug = !word.is(Keyword::error) && !word.is(Keyword::warning);
  if (!debug && text.ends_with('\n')) text.pop_back();  // a message ends its line itself
  if (word.is(Keyword::error)) fail_finally(word.location, "stopped by '#error': " + text);
  report(word.location, std::move(text), debug ? Diagnostic::Severity::debug : Diagnostic::Severity::warning);
}

void Interpreter::run_undef(const Token& word) {
  unsettle();
  const Scopes::Reach reach = take_reach();
  const Token& name = take_identifier(word, reach);
  const Scopes::Binding* binding = scopes().find(name.symbol, reach);
  if (binding == nullptr) {
    warn(name.location, "'" + std::string(name.text) + "' is not declared, so '#undef' changes nothing");
    return;
  }
  const Scopes::Slot slot = binding->slot;
  if (picks_part(*slot, raw_next())) {
    *pick_part(slot, name, Pick::test) = std::monostate();
    return;
  }
  if (const auto* file = std::get_if<std::shared_ptr<DataFile>>(slot.get())) data_files_.close(**file, name.location);
  scopes().remove(name.symbol, reach);
}

Token Interpreter::take_identifier(const Token& word, Scopes::Reach reach) {
  unsettle();
  const Token& name = take_prefixed(reach);
  if (name.kind == TokenKind::identifier) return name;
  const std::string found = name.kind == TokenKind::keyword ? "the reserved word " + describe(name) : describe(name);
  fail(name.location, "expected an identifier after '#" + std::string(word.text) + "', found " + found);
}

void Interpreter::finish() {
  const Location end = peek().location;
  conditions_.check_closed();
  data_files_.close_all();
  if (!language().version_stated()) {
    warn(end,
         "no '#version' in this scene: where 3.7 differs from 3.6 in what it renders, 3.6 holds, so without "
         "'assumed_gamma' "
         "there is no gamma correction");
  } else if (!language().gamma_stated()) {
    warn(end, language().effective_version() < 370
                  ? "no 'assumed_gamma' in this scene for a version before 3.7: there is no gamma correction"
                  : "no 'assumed_gamma' in this scene: it is taken to be 1.0");
  }
  language().store(context_.builder.settings());
}

}  // namespace firstlight::parser
