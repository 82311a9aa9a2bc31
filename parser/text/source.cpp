#include "parser/text/source.h"

#include "parser/text/own_work.h"

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

/// The same behind links, also of one whose target is not there.
fs::path followed(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return resolved(path);
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
  std::vector<std::uint32_t> starts;
  // Exactly so many, but for the lines that end in a lone return: of a large mesh there are millions.
  starts.reserve(1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
  starts.push_back(0);
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
  is_built_in_ = permissions_.empty();
  if (is_built_in_) {
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
  if (found.path.empty()) return {found.leads_out ? Status::forbidden : Status::missing, nullptr, name, false};
  return {Status::found, nullptr, found.path.lexically_normal().string(), found.other_case, found.other_slashes};
}

SourceFiles::Result SourceFiles::place_for_writing(const std::string& name) const {
  const bool is_name = !name.empty() && name.find('\0') == std::string::npos;
  const fs::path named = is_name ? folders_.front() / name : fs::path();
  // Where links outside lead is not to be told.
  const fs::path path = is_name && may_reach(named) ? followed(named) : named.lexically_normal();
  const bool allowed = !path.empty() && path.has_filename() &&
                       std::all_of(permissions_.begin(), permissions_.end(),
                                   [&](const Permissions& permissions) { return permissions.may_write(path); });
  return {allowed ? Status::found : Status::forbidden, nullptr, path.empty() ? name : path.string(), false};
}

bool SourceFiles::may_replace(const fs::path& path) const {
  if (!is_built_in_) return true;
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return true;
  return path != files_.front()->path && is_own_work(path);
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

// A file that may not be read is as if it were not there, so that nothing is told about it: whether a name leads out is
// seen by the name alone.
SourceFiles::Found SourceFiles::find(const std::vector<std::string>& names, const SourceFile& from) const {
  // The current directory's files keep the name they were asked for, which makes for short messages.
  std::vector<fs::path> folders = {fs::path()};
  folders.insert(folders.end(), folders_.begin() + 1, folders_.end());
  folders.insert(folders.begin() + 2, from.path.parent_path());
  bool leads_out = true, link_leads_out = false;
  const auto whole = [&](const fs::path& folder) { return folder.empty() ? folders_.front() : folder; };
  const auto leads_in = [&](const fs::path& folder, const std::string& name) {
    const bool may = may_reach(whole(folder) / name);
    leads_out = leads_out && !may;
    return may;
  };
  for (const fs::path& folder : folders) {
    for (const std::string& name : names) {
      const fs::path path = folder / name;
      if (!leads_in(folder, name)) continue;
      if (!may_read_found(whole(folder) / name)) {
        link_leads_out = true;
      } else if (is_file(path)) {
        return {path, false};
      }
    }
  }
  for (const fs::path& folder : folders) {
    for (const std::string& name : names) {
      if (fs::path(name).is_absolute() || !leads_in(folder, name)) continue;
      const fs::path place = find_ignoring_case(folder.empty() ? fs::path(".") : folder, name);
      if (!place.empty() && is_file(place) && may_read_found(place)) return {place, true};
    }
  }
  // Scenes written on Windows.
  Found found;
  found.leads_out = leads_out || link_leads_out;
  if (names.front().find('\\') == std::string::npos) return found;
  std::vector<std::string> with_slashes = names;
  for (std::string& name : with_slashes) std::replace(name.begin(), name.end(), '\\', '/');
  found = find(with_slashes, from);
  found.other_slashes = true;
  return found;
}

// A link in a standard folder, such as one to a font, is the installation's own and may lead out of it.
bool SourceFiles::may_read_found(const fs::path& path) const {
  const fs::path folder = resolved(path.parent_path());
  const bool standard = std::any_of(kStandardIncludeFolders.begin(), kStandardIncludeFolders.end(),
                                    [&](const char* name) { return resolved(name) == folder; });
  return may_read(standard ? folder / path.filename() : followed(path));
}

bool SourceFiles::may_reach(const fs::path& path) const {
  return std::all_of(permissions_.begin(), permissions_.end(),
                     [&](const Permissions& permissions) { return permissions.may_reach(path); });
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
  Status status = Status::unreadable;
  std::optional<std::string> text = text_of(path, &status);
  if (!text) return {status, nullptr, name, false};
  auto file = std::make_unique<SourceFile>();
  file->text = *std::move(text);
  file->index = static_cast<std::uint32_t>(files_.size());
  file->name = std::move(name);
  file->path = where;
  file->line_starts = find_line_starts(file->text);
  files_.push_back(std::move(file));
  return {Status::found, files_.back().get(), files_.back()->name, false};
}

std::optional<std::string> SourceFiles::text_of(const fs::path& path, Status* why) {
  std::error_code error;
  if (!is_file(path)) return std::nullopt;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return std::nullopt;
  if (size > kLargestFile) {
    if (why != nullptr) *why = Status::too_large;
    return std::nullopt;
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(size, '\0');
  if (!stream || !stream.read(text.data(), static_cast<std::streamsize>(size))) return std::nullopt;
  return text;
}

}  // namespace firstlight::parser
