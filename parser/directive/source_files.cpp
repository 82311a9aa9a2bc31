// The files that a scene is read from: its own, and what it includes.
#include "parser/directive/interpreter.h"
#include "parser/expression/string_expression.h"

#include <filesystem>
#include <optional>
#include <utility>

namespace firstlight::parser {

using render::Diagnostic;

void Interpreter::read_permissions() {
  std::vector<Permissions> all;
  for (const std::string& path : options().permission_files) {
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
  files().restrict_to(std::move(all));
}

void Interpreter::open_scene(const std::string& path) {
  read_permissions();
  const SourceFiles::Result result = files().read_scene(path, options().library_paths);
  if (result.status == SourceFiles::Status::found) {
    *scopes().target(symbols().intern("input_file_name"), false) = std::filesystem::path(path).filename().string();
    const TokenFile& file = tokens_of(*result.file);
    Frame text;
    text.file = &file;
    text.end = static_cast<std::uint32_t>(file.size() - 1);
    enter_frame(std::move(text));
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
  if (!slot) slot = std::make_unique<TokenFile>(file, symbols());
  return *slot;
}

void Interpreter::run_include(const Token& word) {
  const Token& at = peek();
  const std::string name = parse_path(*this);
  unsettle();
  const SourceFiles::Result result = files().read_include(name, frame().file->source());
  found_file(result, name, at.location);
  std::size_t depth = 0;
  for (const Frame& text : frames()) depth += text.macro == nullptr;
  if (depth > kDeepestInclude) {
    fail_finally(word.location,
                 "included files are nested too deeply here (limit " + std::to_string(kDeepestInclude) + ")");
  }
  const TokenFile& file = tokens_of(*result.file);
  Frame text;
  text.file = &file;
  text.end = static_cast<std::uint32_t>(file.size() - 1);
  text.call = at.location;
  enter_frame(std::move(text));
}

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
  return found_file(files().find_file(name, extensions, frame().file->source()), name, at).path;
}

}  // namespace firstlight::parser
