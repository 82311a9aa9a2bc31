#include "parser/text/permissions.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace firstlight::parser {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Without what follows a `;` that is not between quotation marks.
std::string_view without_comment(std::string_view line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == ';') {
      return line.substr(0, i);
    }
  }
  return line;
}

// Whether `folder` is `place` or below it.
bool leads_to(const fs::path& place, const fs::path& folder) {
  return std::mismatch(place.begin(), place.end(), folder.begin(), folder.end()).first == place.end();
}

std::string with_place(std::string text, std::string_view name, const fs::path& place) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + place.string().size())) {
    text.replace(at, name.size(), place.string());
  }
  return text;
}

}  // namespace

Permissions::Places Permissions::places() {
  std::error_code error;
  const char* home = std::getenv("HOME");
  // A root folder is no home: all files are below it.
  const bool is_home = home != nullptr && fs::path(home).is_absolute() &&
                       fs::path(home).lexically_normal() != fs::path(home).root_path();
  return {"/usr/share/povray-3.7", is_home ? home : "", fs::current_path(error)};
}

Permissions Permissions::built_in(const Places& places) {
  Permissions result;
  for (const fs::path& folder : {places.install / "include", fs::path("/usr/share/povray/include"),
                                 fs::path("/usr/share/doc/povray/examples"), places.working}) {
    result.allow_reading(folder);
  }
  result.rules_.back().write = true;
  return result;
}

Permissions::Rule Permissions::rule_of(const fs::path& folder) {
  Rule rule;
  rule.folder = canonical(folder);
  std::error_code error;
  rule.spelled = fs::absolute(folder, error).lexically_normal();
  if (!rule.spelled.has_filename()) rule.spelled = rule.spelled.parent_path();
  return rule;
}

void Permissions::allow_reading(const fs::path& folder) {
  rules_.push_back(rule_of(folder));
  rules_.back().below = rules_.back().folder != rules_.back().folder.root_path();
}

Permissions Permissions::parse(std::string_view text, const Places& places, std::vector<std::string>& problems) {
  enum class Section { none, file_security, paths, other };
  Permissions result;
  Section section = Section::none;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    const std::string_view line = trimmed(without_comment(text.substr(0, end + (text[end] == '\n' ? 0 : 1))));
    text.remove_prefix(end + 1);
    ++number;
    if (line.empty()) continue;
    if (line.front() == '[') {
      section = line == "[File I/O Security]"   ? Section::file_security
                : line == "[Permitted Paths]"   ? Section::paths
                : line == "[Shellout Security]" ? Section::other
                                                : Section::none;
      if (section != Section::none) continue;
    } else if (section == Section::other || (section == Section::paths && result.parse_rule(line, places))) {
      continue;
    } else if (section == Section::file_security && (line == "none" || line == "read-only" || line == "restricted")) {
      result.security_ = line == "none"        ? Security::none
                         : line == "read-only" ? Security::read_only
                                               : Security::restricted;
      continue;
    }
    problems.push_back("line " + std::to_string(number) + ": '" + std::string(line) + "' has no meaning here");
  }
  return result;
}

// `read+write* = "folder"`
bool Permissions::parse_rule(std::string_view line, const Places& places) {
  const std::size_t equal = line.find('=');
  if (equal == std::string_view::npos) return false;
  std::string_view access = trimmed(line.substr(0, equal));
  std::string_view folder = trimmed(line.substr(equal + 1));
  const bool below = access.ends_with('*');
  if (below) access = trimmed(access.substr(0, access.size() - 1));
  if (access != "read" && access != "read+write") return false;
  if (folder.size() >= 2 && (folder.front() == '"' || folder.front() == '\'') && folder.back() == folder.front()) {
    folder = folder.substr(1, folder.size() - 2);
  }
  if (folder.empty()) return false;
  // Nothing is permitted in a home that there is none of.
  if (places.home.empty() && folder.find("%HOME%") != std::string_view::npos) return true;
  std::string name = with_place(std::string(folder), "%INSTALLDIR%", places.install);
  name = with_place(std::move(name), "%HOME%", places.home);
  name = with_place(std::move(name), "%CWD%", places.working);
  Rule rule = rule_of(places.working / name);
  rule.below = below;
  rule.write = access == "read+write";
  rule.hidden = true;
  rules_.push_back(std::move(rule));
  return true;
}

bool Permissions::may_read(const fs::path& path) const {
  return security_ != Security::restricted || matches(path, false);
}

bool Permissions::may_write(const fs::path& path) const { return security_ == Security::none || matches(path, true); }

fs::path Permissions::canonical(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(path, error);
  if (error) return {};
  return result.has_filename() || result == result.root_path() ? result : result.parent_path();
}

bool Permissions::may_reach(const fs::path& path) const {
  if (security_ != Security::restricted) return true;
  const auto permits = [&](const fs::path& place) {
    return std::any_of(rules_.begin(), rules_.end(), [&](const Rule& rule) {
      return leads_to(place, rule.folder) || leads_to(place, rule.spelled) || holds(rule, rule.folder, place) ||
             holds(rule, rule.spelled, place);
    });
  };
  fs::path place;
  for (const fs::path& part : path) {
    place = (place / part).lexically_normal();
    if (!place.has_filename() && place != place.root_path()) place = place.parent_path();
    if (!permits(place)) return false;
  }
  return true;
}

bool Permissions::matches(const fs::path& path, bool write) const {
  return std::any_of(rules_.begin(), rules_.end(), [&](const Rule& rule) {
    return !rule.folder.empty() && (!write || rule.write) && holds(rule, rule.folder, path);
  });
}

// `folder` is the rule's, in one of its spellings.
bool Permissions::holds(const Rule& rule, const fs::path& folder, const fs::path& path) {
  const auto [in_folder, in_path] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  if (folder.empty() || in_folder != folder.end()) return false;
  if (!rule.below && std::distance(in_path, path.end()) > 1) return false;
  return rule.hidden || std::none_of(in_path, path.end(), [](const fs::path& part) {
           return part.native().size() > 1 && part.native().front() == '.';
         });
}

}  // namespace firstlight::parser
