#include "app/compare/list_options.h"

#include "app/pov_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <system_error>
#include <utility>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

constexpr int kMostJobs = 256;

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_scene(const std::string& path) { return lower(path).ends_with(".pov"); }

class Reader {
 public:
  explicit Reader(ListCommandLine& line) : line_(line) {}

  /// Takes what is ours and returns the rest.
  std::vector<std::string> read(std::span<const std::string> arguments) {
    std::vector<std::string> rest;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const std::string& word = arguments[i];
      const std::size_t equals = word.find('=');
      const std::string name = word.substr(0, equals);
      if (word == "--again" || word == "--povray-too") {
        (word == "--again" ? line_.again : line_.povray_too) = true;
        line_.is_asked_for = true;
      } else if (!takes_value(name) || (name == "--json" && equals == std::string::npos)) {
        rest.push_back(word);
      } else if (equals != std::string::npos) {
        take(name, word.substr(equals + 1));
      } else if (i + 1 < arguments.size()) {
        take(name, arguments[++i]);
      } else {
        errors_.push_back(fmt::format("option '{}': expected a value after it", word));
      }
    }
    return rest;
  }

  const std::vector<std::string>& errors() const { return errors_; }

 private:
  static bool takes_value(std::string_view name) {
    constexpr std::string_view kOwn[] = {"--list", "--root", "--jobs", "--cache", "--report", "--agreement", "--json"};
    return std::ranges::find(kOwn, name) != std::end(kOwn);
  }

  void take(const std::string& name, const std::string& value) {
    line_.is_asked_for = true;
    if (name == "--jobs") {
      const auto jobs = parse<int>(value);
      if (jobs && *jobs >= 1 && *jobs <= kMostJobs) {
        line_.jobs = *jobs;
      } else {
        errors_.push_back(fmt::format("--jobs: expected a number from 1 to {}, found '{}'", kMostJobs, value));
      }
      return;
    }
    if (value.empty()) errors_.push_back(fmt::format("{}: expected a path", name));
    fs::path& path = name == "--list"     ? line_.list
                     : name == "--root"   ? line_.root
                     : name == "--cache"  ? line_.cache
                     : name == "--report" ? line_.report
                     : name == "--json"   ? line_.json
                                          : line_.agreement;
    path = value;
  }

  ListCommandLine& line_;
  std::vector<std::string> errors_;
};

/// Adds errors for options that do not fit together.
void check(ListCommandLine& line) {
  const std::vector<std::string>& subjects = line.common.subjects;
  std::vector<std::string>& errors = line.common.errors;
  if (!line.list.empty() && !subjects.empty()) {
    errors.push_back(fmt::format("compare: a list and '{}': expected one of them", subjects[0]));
  }
  if (line.list.empty() && subjects.empty()) errors.emplace_back("compare: expected a folder, a list or scenes");
  if (line.list.empty() && !line.root.empty()) errors.emplace_back("--root: has a meaning only with --list");
  for (const std::string& subject : subjects) {
    if (!is_folder(subject) && !is_scene(subject)) {
      errors.push_back(fmt::format("compare: expected a folder or a scene, found '{}'", subject));
    }
  }
  if (!line.common.keep.empty()) errors.emplace_back("--keep: of many scenes --report keeps the pictures");
  if (line.common.ini && subjects.size() != 1) {
    errors.emplace_back("compare: an .ini file is of one scene; a list names one behind its scene");
  }
}

}  // namespace

ListCommandLine parse_list_command_line(std::span<const std::string> arguments) {
  ListCommandLine line;
  Reader reader(line);
  const std::vector<std::string> rest = reader.read(arguments);
  line.common = parse_compare_command_line(rest);
  const std::vector<std::string>& subjects = line.common.subjects;
  const auto holds_scenes = [](const std::string& subject) { return is_folder(subject) || is_scene(subject); };
  const bool one_scene = subjects.size() == 1 && !is_folder(subjects[0]);
  if (!subjects.empty() && !one_scene && std::ranges::all_of(subjects, holds_scenes)) line.is_asked_for = true;
  if (line.common.wish == CompareCommandLine::Wish::help) line.is_asked_for = false;
  if (!line.is_asked_for) return line;
  line.common.errors.insert(line.common.errors.end(), reader.errors().begin(), reader.errors().end());
  check(line);
  return line;
}

}  // namespace firstlight::app::compare
