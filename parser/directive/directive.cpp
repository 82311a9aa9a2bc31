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
    const TokenFile file = tokenize(source, none);
    if (file.tokens.size() != 2 || file.tokens[0].kind != TokenKind::number) return false;
    number.values[0] = start == 1 ? -file.tokens[0].number : file.tokens[0].number;
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
    *scopes_.target(symbols_.intern(name), false) = std::move(value);
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

void Interpreter::read_permissions() {
  std::vector<Permissions> all;
  for (const std::string& path : options_.permission_files) {
    Diagnostic error;
    error.file = path;
    error.message = "the permissions cannot be read";
    const std::optional<std::string> text = SourceFiles::text_of(path);
    if (!text) throw SyntaxError({error});
    std::vector<std::string> problems;
    all.push_back(Permissions::parse(*text, Permissions::places(), problems));
    if (problems.empty()) continue;
    error.message = problems.front();
    throw SyntaxError({error});
  }
  files_.restrict_to(std::move(all));
}

void Interpreter::open_scene(const std::string& path) {
  read_permissions();
  const SourceFiles::Result result = files_.read_scene(path, options_.library_paths);
  if (result.status == SourceFiles::Status::found) {
    *scopes_.target(symbols_.intern("input_file_name"), false) = std::filesystem::path(path).filename().string();
    const TokenFile& file = tokens_of(*result.file);
    Frame frame;
    frame.file = &file;
    frame.end = static_cast<std::uint32_t>(file.tokens.size() - 1);
    enter_frame(std::move(frame));
    return;
  }
  Diagnostic error;
  error.file = path;
  switch (result.status) {
    case SourceFiles::Status::missing:
      error.message = "there is no such file";
      break;
    case SourceFiles::Status::too_large:
      error.message = "the file is too large (limit " + std::to_string(SourceFiles::kLargestFile >> 20) + " MiB)";
      break;
    default:
      error.message = "the file cannot be read";
      break;
  }
  throw SyntaxError({error});
}

const TokenFile& Interpreter::tokens_of(const SourceFile& file) {
  if (file.index >= token_files_.size()) token_files_.resize(file.index + 1);
  std::unique_ptr<TokenFile>& slot = token_files_[file.index];
  if (!slot) {
    slot = std::make_unique<TokenFile>(tokenize(file, symbols_));
    slot->first = tokens_cut_;
    tokens_cut_ += slot->tokens.size();
  }
  return *slot;
}

void Interpreter::count_step(const Location& at) {
  replays_ = true;
  if (++steps_ > kMostSteps) {
    fail_finally(at, "this scene turns in loops or macros without end (limit " + std::to_string(kMostSteps) +
                         " turns and calls)");
  }
}

void Interpreter::run_directive() {
  Frame& frame = frames_.back();
  const std::uint32_t hash = frame.position;
  const Token& word = frame.file->tokens[hash + 1];
  frame.position = std::min(hash + 2, frame.end);
  count(word.keyword);
  obey(word, hash);
}

void Interpreter::obey(const Token& word, std::uint32_t hash) {
  switch (word.keyword) {
    case Keyword::declare:
    case Keyword::local:
      return run_declare(word, true);
    case Keyword::undef:
      return run_undef(word);
    case Keyword::if_:
    case Keyword::ifdef:
    case Keyword::ifndef:
      return run_if(word, hash);
    case Keyword::else_:
    case Keyword::elseif:
    case Keyword::case_:
    case Keyword::range:
      return run_further_branch(word, hash);
    case Keyword::switch_:
      return run_switch(word, hash);
    case Keyword::while_:
      return run_while(word, hash);
    case Keyword::for_:
      return run_for(word, hash);
    case Keyword::end:
      return run_end(word, hash);
    case Keyword::break_:
      return run_break(word);
    case Keyword::macro:
      return define_macro(word, hash);
    case Keyword::include:
      return run_include(word);
    case Keyword::version:
      return run_version(word, hash == 0 && frames_.size() == 1);
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
      return run_fopen(word);
    case Keyword::fclose:
      return run_fclose(word);
    case Keyword::read:
      return run_read(word);
    case Keyword::write:
      return run_write(word);
    default:
      break;
  }
  const bool undeclared = word.kind == TokenKind::identifier && scopes_.find(word.symbol) == nullptr;
  if (undeclared || word.is_end()) {
    fail(word.location, "expected a directive after '#', found " + describe(word) + suggestion(word.text));
  }
  // POV-Ray passes over a '#' that begins no directive.
  warn(word.location, "expected a directive after '#', found " + describe(word) + "; the '#' is ignored");
  frames_.back().position = hash + 1;
}

void Interpreter::run_bare_directive() {
  const Token& word = take();
  warn(word.location, "'" + std::string(word.text) + "' should be written '#" + std::string(word.text) + "'");
  const Nesting nesting(*this);
  switch (word.keyword) {
    case Keyword::declare:
      return run_declare(word, false);
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
  const Scopes::Binding* binding = scopes_.find(name.symbol, reach);
  if (binding == nullptr) {
    warn(name.location, "'" + std::string(name.text) + "' is not declared, so '#undef' changes nothing");
    return;
  }
  const Scopes::Slot slot = binding->slot;
  if (picks_part(*slot, raw_next())) {
    *pick_part(slot, name, Pick::test) = std::monostate();
    return;
  }
  if (const auto* file = std::get_if<std::shared_ptr<DataFile>>(slot.get())) close_data_file(**file, name.location);
  scopes_.remove(name.symbol, reach);
}

void Interpreter::run_include(const Token& word) {
  const Token& at = peek();
  const std::string name = parse_path(*this);
  unsettle();
  const SourceFiles::Result result = files_.read_include(name, *frames_.back().file->source);
  found_file(result, name, at.location);
  std::size_t depth = 0;
  for (const Frame& frame : frames_) depth += frame.macro == nullptr;
  if (depth > kDeepestInclude) {
    fail_finally(word.location,
                 "included files are nested too deeply here (limit " + std::to_string(kDeepestInclude) + ")");
  }
  const TokenFile& file = tokens_of(*result.file);
  Frame frame;
  frame.file = &file;
  frame.end = static_cast<std::uint32_t>(file.tokens.size() - 1);
  frame.call = at.location;
  enter_frame(std::move(frame));
}

// Says what is wrong when the file was not found, or not by that name.
const SourceFiles::Result& Interpreter::found_file(const SourceFiles::Result& result, const std::string& name,
                                                   const Location& at) {
  switch (result.status) {
    case SourceFiles::Status::found:
      break;
    case SourceFiles::Status::missing:
      fail(at, "there is no file '" + name + "' in the current folder, the scene's or the library folders");
    case SourceFiles::Status::forbidden:
      fail(at, "'" + name +
                   "' may not be read: a scene may read files of its own folder, the current folder, the library "
                   "folders, and where its permissions allow");
    case SourceFiles::Status::too_large:
      fail(at,
           "'" + result.path + "' is too large (limit " + std::to_string(SourceFiles::kLargestFile >> 20) + " MiB)");
    case SourceFiles::Status::unreadable:
      fail(at, "'" + result.path + "' cannot be read");
  }
  if (result.other_slashes) {
    warn(at, "there is no file '" + name + "'; '" + result.path + "' is read, as if each '\\' in the name were '/'");
  } else if (result.other_case) {
    warn(at,
         "there is no file '" + name + "'; '" + result.path + "' is read, whose name differs in upper and lower case");
  }
  return result;
}

std::string Interpreter::find_file(const std::string& name, const std::vector<std::string>& extensions,
                                   const Location& at) {
  return found_file(files_.find_file(name, extensions, *frames_.back().file->source), name, at).path;
}

const Token& Interpreter::take_identifier(const Token& word, Scopes::Reach reach) {
  unsettle();
  const Token& name = take_prefixed(reach);
  if (name.kind == TokenKind::identifier) return name;
  const std::string found = name.kind == TokenKind::keyword ? "the reserved word " + describe(name) : describe(name);
  fail(name.location, "expected an identifier after '#" + std::string(word.text) + "', found " + found);
}

void Interpreter::finish() {
  const Location end = peek().location;
  if (!conditions_.empty()) fail_unclosed(*conditions_.back().word);
  close_data_files();
  if (!language_.version_stated()) {
    warn(end,
         "no '#version' in this scene: where 3.7 differs from 3.6 in what it renders, 3.6 holds, so without "
         "'assumed_gamma' "
         "there is no gamma correction");
  } else if (!language_.gamma_stated()) {
    warn(end, language_.effective_version() < 370
                  ? "no 'assumed_gamma' in this scene for a version before 3.7: there is no gamma correction"
                  : "no 'assumed_gamma' in this scene: it is taken to be 1.0");
  }
  language_.store(context_.builder.settings());
}

}  // namespace firstlight::parser
