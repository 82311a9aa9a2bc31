#include "parser/source.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace firstlight::parser {

namespace fs = std::filesystem;

namespace {

// Where the povray-includes package puts the standard include files.
constexpr std::array<const char*, 2> kStandardIncludeFolders = {"/usr/share/povray-3.7/include",
                                                                "/usr/share/povray/include"};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

fs::path resolved(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(path, error);
  return error ? fs::path() : result;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// The names a file may go by: POV-Ray appends the extension where it is absent.
std::vector<std::string> candidate_names(const std::string& name, const std::vector<std::string>& extensions) {
  std::vector<std::string> names;
  if (!fs::path(name).has_extension()) {
    for (const std::string& extension : extensions) names.push_back(name + extension);
  }
  names.push_back(name);
  return names;
}

// `relative` below `folder`, each part of it in whatever case it exists there; empty when there is none.
fs::path find_ignoring_case(const fs::path& folder, const fs::path& relative) {
  fs::path place = folder;
  for (const fs::path& part : relative) {
    std::error_code error;
    if (part == "." || part == ".." || fs::exists(place / part, error)) {
      place /= part;
      continue;
    }
    const std::string wanted = lower_case(part.string());
    // The first in alphabetical order, so that the choice does not depend on the file system.
    std::string best;
    for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
      const std::string found = entry->path().filename().string();
      if (lower_case(found) == wanted && (best.empty() || found < best)) best = found;
    }
    if (best.empty()) return {};
    place /= best;
  }
  return place;
}

std::vector<std::uint32_t> find_line_starts(std::string_view text) {
  std::vector<std::uint32_t> starts{0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool lone_return = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
    if (text[i] == '\n' || lone_return) starts.push_back(static_cast<std::uint32_t>(i + 1));
  }
  return starts;
}

bool declares(std::string_view text, std::string_view name) {
  for (const std::string_view directive : {"#declare ", "#macro "}) {
    const std::string wanted = std::string(directive) + std::string(name);
    for (std::size_t at = text.find(wanted); at != std::string_view::npos; at = text.find(wanted, at + 1)) {
      const std::size_t end = at + wanted.size();
      const bool whole =
          end == text.size() || (std::isalnum(static_cast<unsigned char>(text[end])) == 0 && text[end] != '_');
      if (whole && (at == 0 || text[at - 1] == '\n')) return true;
    }
  }
  return false;
}

std::vector<fs::path> include_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".inc") files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::string SourceFile::line(std::uint32_t number) const {
  if (number == 0 || number > line_starts.size()) return {};
  const std::size_t begin = line_starts[number - 1];
  std::size_t end = number < line_starts.size() ? line_starts[number] : text.size();
  while (end > begin && (text[end - 1] == '\n' || text[end - 1] == '\r')) --end;
  return text.substr(begin, end - begin);
}

render::Diagnostic diagnostic_at(const SourceFile& file, const Location& location,
                                 render::Diagnostic::Severity severity, std::string message) {
  render::Diagnostic result;
  result.severity = severity;
  result.file = file.name;
  result.line = location.line;
  result.column = location.column;
  result.length = std::max<std::uint32_t>(location.length, 1);
  result.message = std::move(message);
  result.source_line = file.line(location.line);
  return result;
}

SourceFiles::Result SourceFiles::read_scene(const std::string& path, const std::vector<std::string>& library_paths) {
  std::error_code error;
  folders_.push_back(resolved(fs::current_path(error)));
  folders_.push_back(resolved(fs::absolute(path, error)).parent_path());
  for (const std::string& folder : library_paths) folders_.push_back(resolved(folder));
  for (const char* folder : kStandardIncludeFolders) folders_.push_back(resolved(folder));
  if (permissions_.empty()) {
    permissions_.push_back(Permissions::built_in(Permissions::places()));
    for (const fs::path& folder : folders_) permissions_.back().allow_reading(folder);
  }
  if (!fs::exists(path, error)) return {Status::missing, nullptr, path, false};
  return read(path, path);
}

SourceFiles::Result SourceFiles::read_include(const std::string& name, const SourceFile& from) {
  return read_found(find_file(name, {".inc", ".INC"}, from));
}

SourceFiles::Result SourceFiles::read_data(const std::string& name, const SourceFile& from) {
  return read_found(find_file(name, {}, from));
}

SourceFiles::Result SourceFiles::read_found(Result found) {
  if (found.status != Status::found) return found;
  Result result = read(found.path, found.path);
  result.other_case = found.other_case;
  result.other_slashes = found.other_slashes;
  return result;
}

SourceFiles::Result SourceFiles::find_file(const std::string& name, const std::vector<std::string>& extensions,
                                           const SourceFile& from) const {
  if (name.empty() || name.find('\0') != std::string::npos) return {Status::missing, nullptr, name, false};
  const Found found = find(candidate_names(name, extensions), from);
  if (found.path.empty()) return {Status::missing, nullptr, name, false};
  return {may_read_found(found.path) ? Status::found : Status::forbidden, nullptr,
          found.path.lexically_normal().string(), found.other_case, found.other_slashes};
}

SourceFiles::Result SourceFiles::place_for_writing(const std::string& name) const {
  const bool is_name = !name.empty() && name.find('\0') == std::string::npos;
  const fs::path path = is_name ? resolved(folders_.front() / name) : fs::path();
  const bool allowed = !path.empty() && path.has_filename() &&
                       std::all_of(permissions_.begin(), permissions_.end(),
                                   [&](const Permissions& permissions) { return permissions.may_write(path); });
  return {allowed ? Status::found : Status::forbidden, nullptr, path.empty() ? name : path.string(), false};
}

std::string SourceFiles::standard_file_with(std::string_view name) const {
  for (const char* folder : kStandardIncludeFolders) {
    for (const fs::path& path : include_files_in(folder)) {
      const fs::path where = resolved(path);
      const bool known =
          std::any_of(files_.begin(), files_.end(), [&](const auto& file) { return file->path == where; });
      if (known || !is_file(path) || !may_read_found(path)) continue;
      std::ifstream stream(path, std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      if (declares(text, name)) return path.filename().string();
    }
  }
  return {};
}

void SourceFiles::forget(const fs::path& canonical) {
  for (const auto& file : files_) {
    if (file->path == canonical) file->path.clear();
  }
}

SourceFiles::Found SourceFiles::find(const std::vector<std::string>& names, const SourceFile& from) const {
  // The current directory's files keep the name they were asked for, which makes for short messages.
  std::vector<fs::path> folders = {fs::path()};
  folders.insert(folders.end(), folders_.begin() + 1, folders_.end());
  folders.insert(folders.begin() + 2, from.path.parent_path());
  for (const fs::path& folder : folders) {
    for (const std::string& name : names) {
      if (is_file(folder / name)) return {folder / name, false};
    }
  }
  if (fs::path(names.front()).is_absolute()) return {};
  for (const fs::path& folder : folders) {
    for (const std::string& name : names) {
      const fs::path found = find_ignoring_case(folder.empty() ? fs::path(".") : folder, name);
      if (!found.empty() && is_file(found)) return {found, true};
    }
  }
  // Scenes written on Windows.
  if (names.front().find('\\') == std::string::npos) return {};
  std::vector<std::string> with_slashes = names;
  for (std::string& name : with_slashes) std::replace(name.begin(), name.end(), '\\', '/');
  Found found = find(with_slashes, from);
  found.other_slashes = true;
  return found;
}

// A link in a standard folder, such as one to a font, is the installation's own and may lead out of it.
bool SourceFiles::may_read_found(const fs::path& path) const {
  const fs::path folder = resolved(path.parent_path());
  const bool standard = std::any_of(kStandardIncludeFolders.begin(), kStandardIncludeFolders.end(),
                                    [&](const char* name) { return resolved(name) == folder; });
  return may_read(standard ? folder / path.filename() : resolved(path));
}

bool SourceFiles::may_read(const fs::path& path) const {
  return std::all_of(permissions_.begin(), permissions_.end(),
                     [&](const Permissions& permissions) { return permissions.may_read(path); });
}

SourceFiles::Result SourceFiles::read(const fs::path& path, std::string name) {
  const fs::path where = resolved(path);
  for (const auto& file : files_) {
    if (file->path == where) return {Status::found, file.get(), name, false};
  }
  std::error_code error;
  if (!is_file(path)) return {Status::unreadable, nullptr, name, false};
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return {Status::unreadable, nullptr, name, false};
  if (size > kLargestFile) return {Status::too_large, nullptr, name, false};
  std::ifstream stream(path, std::ios::binary);
  auto file = std::make_unique<SourceFile>();
  file->text.resize(size);
  if (!stream || !stream.read(file->text.data(), static_cast<std::streamsize>(size))) {
    return {Status::unreadable, nullptr, name, false};
  }
  file->index = static_cast<std::uint32_t>(files_.size());
  file->name = std::move(name);
  file->path = where;
  file->line_starts = find_line_starts(file->text);
  files_.push_back(std::move(file));
  return {Status::found, files_.back().get(), files_.back()->name, false};
}

}  // namespace firstlight::parser
