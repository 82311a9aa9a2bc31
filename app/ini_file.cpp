#include "app/ini_file.h"

#include "app/pov_switches.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

namespace firstlight::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 1 << 20;

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The end of the quoted part that begins at `at`; `at` itself if none begins there. A quote without a partner, as in
/// bob's.pov, is an ordinary character.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  if (text[at] != '"' && text[at] != '\'') return at;
  const std::size_t partner = text.find(text[at], at + 1);
  return partner == std::string_view::npos ? at : partner;
}

/// Where the first of `wanted` stands outside quotes; the size of `text` if nowhere.
std::size_t find_unquoted(std::string_view text, std::string_view wanted) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (wanted.find(text[i]) != std::string_view::npos) return i;
    i = end_of_quoted(text, i);
  }
  return text.size();
}

/// "my file" without its quotes, if they are around the whole.
std::string_view unquoted(std::string_view text) {
  const bool is_quoted =
      text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.find(text[0], 1) + 1 == text.size();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// Words between blanks; quotes keep what is between them together and vanish: +I"my file.pov".
std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t length = find_unquoted(text, " \t\r\f\v");
    const std::string_view part = text.substr(0, length);
    std::string word;
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (const std::size_t end = end_of_quoted(part, i); end != i) {
        word += part.substr(i + 1, end - i - 1);
        i = end;
      } else {
        word += part[i];
      }
    }
    words.push_back(std::move(word));
    text.remove_prefix(length);
  }
  return words;
}

/// Where the '=' of "Key = value" stands; nothing if the line is no setting.
std::optional<std::size_t> find_assignment(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  const std::string_view key = trimmed(line.substr(0, equals));
  const bool is_key =
      !key.empty() && std::ranges::all_of(key, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  return is_key ? std::optional(equals) : std::nullopt;
}

/// "Library_Path=a, b" means two settings.
std::vector<std::string> assignments(std::string_view key, std::string_view value) {
  std::vector<std::string> out;
  const bool is_list = lower(key) == "library_path";
  do {
    const std::size_t end = is_list ? find_unquoted(value, ",") : value.size();
    out.push_back(fmt::format("{}={}", key, unquoted(trimmed(value.substr(0, end)))));
    value.remove_prefix(std::min(end + 1, value.size()));
  } while (!value.empty());
  return out;
}

std::vector<std::string> words_of(std::string_view line) {
  if (const auto equals = find_assignment(line)) {
    return assignments(trimmed(line.substr(0, *equals)), trimmed(line.substr(*equals + 1)));
  }
  return split_words(line);
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Empty when there is none.
fs::path find_ini(const std::string& name, std::span<const std::string> folders) {
  const auto with_extension = [](fs::path path) { return path.has_extension() ? path : path += ".ini"; };
  if (const fs::path here = with_extension(name); is_file(here)) return here;
  if (fs::path(name).is_absolute()) return {};
  for (const std::string& folder : folders) {
    if (const fs::path there = with_extension(fs::path(folder) / name); is_file(there)) return there;
  }
  return {};
}

}  // namespace

IniText parse_ini(std::string_view text, std::string_view section) {
  IniText out;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  bool counts = true;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    line = trimmed(line);
    if (line.starts_with('[')) {
      const std::string_view name = line.substr(1, line.find(']') - 1);
      counts = !section.empty() && lower(name) == lower(section);
      out.has_section = out.has_section || counts;
      out.sections.emplace_back(name);
      continue;
    }
    if (!counts) continue;
    std::vector<std::string> words = words_of(trimmed(line.substr(0, find_unquoted(line, ";#"))));
    if (!words.empty()) out.lines.push_back({number, std::move(words)});
  }
  return out;
}

bool is_ini_name(const std::string& word) {
  if (word.empty() || word[0] == '+' || word[0] == '-' || word.find('=') != std::string::npos) return false;
  const IniName name = split_ini_name(word);
  const std::string extension = lower(fs::path(name.file).extension().string());
  if (extension == ".ini" || extension.starts_with(".ini[")) return true;
  if (!extension.empty() || name.file.ends_with('/')) return false;
  return !is_file(word) && is_file(name.file + ".ini");
}

IniName split_ini_name(const std::string& word) {
  const std::size_t bracket = word.find('[');
  if (bracket == std::string::npos || word.back() != ']') return {word, {}};
  return {word.substr(0, bracket), word.substr(bracket + 1, word.size() - bracket - 2)};
}

IniText read_ini(const IniName& name, std::span<const std::string> folders, std::string& error) {
  const fs::path path = find_ini(name.file, folders);
  if (path.empty()) {
    error = fmt::format("{}: there is no such .ini file", name.file);
    return {};
  }
  std::error_code unknown;
  if (const std::uintmax_t size = fs::file_size(path, unknown); !unknown && size > kLargestFile) {
    error = fmt::format("{}: an .ini file of {} bytes is too large; {} are allowed", name.file, size, kLargestFile);
    return {};
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream || text.find('\0') != std::string::npos) {
    error = fmt::format("{}: {}", name.file, stream ? "this is not a text file" : "the file cannot be read");
    return {};
  }
  IniText out = parse_ini(text, name.section);
  if (!name.section.empty() && !out.has_section) {
    constexpr std::size_t kMostListed = 20;
    const std::span listed = std::span(out.sections).first(std::min(out.sections.size(), kMostListed));
    error = fmt::format(
        "{}: there is no section [{}]; {}", name.file, name.section,
        listed.empty() ? "the file has no sections" : fmt::format("there are [{}]", fmt::join(listed, "], [")));
    return {};
  }
  return out;
}

}  // namespace firstlight::app
