#include "app/argument_reader.h"

#include "app/ini_file.h"
#include "app/pov_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace firstlight::app {
namespace {

/// POV-Ray's other names of options of ours; empty for all that is none.
std::string_view other_name(std::string_view word) {
  const std::string small = lower(word);
  if (small == "-h" || small == "-?" || small == "-help") return "--help";
  if (small == "-version" || small == "--v") return "--version";
  return {};
}

constexpr int kDeepestIni = 10;       // POV-Ray's limit
constexpr int kMostIniLines = 20000;  // ten levels could repeat one line without end

/// "Key=value", as against a file's name with an equals sign in it.
bool is_assignment(const std::string& word, std::size_t equals) {
  return equals != std::string::npos && equals > 0 &&
         std::all_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(equals),
                     [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

}  // namespace

void ArgumentReader::read(std::span<const std::string> words) {
  while (!words.empty()) {
    const std::string& word = words[0];
    words = words.subspan(1);
    if (const std::string_view name = other_name(word); !name.empty()) {
      long_options_.read_word(std::string(name));
    } else if (word.starts_with("--")) {
      read_long_option(word, words);
    } else if (is_ini_name(word)) {
      read_ini_file(word);
    } else if (!read_own_setting(word)) {
      pov_.read_word(word);
    }
  }
}

void ArgumentReader::read_long_option(const std::string& word, std::span<const std::string>& rest) {
  const std::string name = word.substr(0, word.find('='));
  if (!long_options_.knows(name)) {
    const std::string near = nearest(name, long_options_.names());
    out_.errors.push_back(
        fmt::format("unknown option '{}'{}", word,
                    near.empty() ? std::string("; --help lists all") : "; the nearest known one is " + near));
    return;
  }
  if (!long_options_.takes_value(name) || name != word) return long_options_.read_word(word);
  if (rest.empty()) {
    out_.errors.push_back(fmt::format("option '{}': expected a value after it", word));
    return;
  }
  long_options_.read_word(word + "=" + rest[0]);
  rest = rest.subspan(1);
}

bool ArgumentReader::read_own_setting(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (!is_assignment(word, equals)) return false;
  const std::string name = lower(std::string_view(word).substr(0, equals));
  if (is_setting(name)) return false;
  const std::string option = option_of_setting(name);
  if (long_options_.knows(option)) {
    long_options_.read_word(option + word.substr(equals));
    return true;
  }
  if (lower(word).ends_with(".pov")) return false;
  std::vector<std::string> known = known_settings();
  for (const std::string& own : long_options_.names()) known.push_back(setting_of_option(own));
  const std::string near = nearest(name, known);
  out_.errors.push_back(
      fmt::format("unknown setting '{}'{}", word, near.empty() ? "" : "; the nearest known one is " + near + "="));
  return true;
}

void ArgumentReader::read_ini_file(const std::string& word) {
  const IniName name = split_ini_name(word);
  if (depth_ == kDeepestIni) {
    out_.errors.push_back(fmt::format("{}: .ini files name each other more than {} deep", word, kDeepestIni));
    return;
  }
  std::string problem;
  const IniText text = read_ini(name, out_.options.library_paths, problem);
  if (!problem.empty()) return out_.errors.push_back(problem);
  ++depth_;
  for (const IniLine& line : text.lines) {
    if (++ini_lines_ > kMostIniLines) {
      if (ini_lines_ == kMostIniLines + 1) {
        out_.errors.push_back(fmt::format("{}: the .ini files have more than {} lines", name.file, kMostIniLines));
      }
      break;
    }
    const std::size_t errors = out_.errors.size();
    read(line.words);
    for (std::size_t i = std::max(errors, placed_errors_); i < out_.errors.size(); ++i) {
      out_.errors[i] = fmt::format("{}:{}: {}", name.file, line.number, out_.errors[i]);
    }
    placed_errors_ = out_.errors.size();
  }
  --depth_;
}

}  // namespace firstlight::app
