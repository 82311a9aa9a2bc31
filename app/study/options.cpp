#include "app/study/options.h"

#include "app/pov_switches.h"
#include "priority/schemes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace firstlight::app {
namespace {

constexpr int kMostRounds = 1000;
constexpr std::string_view kRecursive = "recursive";

/// The scheme texts between semicolons: a comma belongs to a text.
std::vector<std::string> split_schemes(const std::string& text) {
  std::vector<std::string> schemes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string_view part = std::string_view(text).substr(begin, end - begin);
    const std::size_t first = part.find_first_not_of(" \t");
    if (first != std::string_view::npos) {
      schemes.emplace_back(part.substr(first, part.find_last_not_of(" \t") - first + 1));
    }
    begin = end + 1;
  }
  return schemes;
}

void read_own_option(StudyCommandLine& line, const std::string& name, const std::string& value) {
  if (name == "--out") {
    line.options.folder = value;
    if (value.empty()) line.errors.emplace_back("--out: expected a folder");
  } else if (name == "--schemes") {
    line.options.schemes = split_schemes(value);
    if (line.options.schemes.empty()) line.errors.emplace_back("--schemes: expected schemes with semicolons between");
  } else {
    const auto rounds = parse<int>(value);
    if (!rounds || *rounds < 1 || *rounds > kMostRounds) {
      line.errors.push_back(fmt::format("--rounds: expected a number from 1 to {}, found '{}'", kMostRounds, value));
    } else {
      line.options.rounds = *rounds;
    }
  }
}

/// The study itself decides on all that would change the order or the end of a picture.
void refuse_what_does_not_fit(StudyCommandLine& line) {
  const Options& options = line.options.scene;
  for (const auto& [given, name] :
       {std::pair(!options.boosts.empty(), "--boost"), std::pair(options.stop_at_error != 0.0, "--stop-at-error"),
        std::pair(options.stop_after != 0.0, "--stop-after"), std::pair(!options.steer.empty(), "--steer"),
        std::pair(!options.stats_file.empty(), "--stats"),
        std::pair(!options.snapshots_folder.empty(), "--snapshots")}) {
    if (given) line.errors.push_back(fmt::format("study: {} has no meaning here", name));
  }
}

}  // namespace

StudyCommandLine parse_study_command_line(std::span<const std::string> arguments) {
  constexpr std::array<std::string_view, 3> kOwn{"--out", "--schemes", "--rounds"};
  StudyCommandLine line;
  std::vector<std::string> others;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const std::size_t equals = word.find('=');
    const std::string name = word == "-o" ? "--out" : word.substr(0, equals);
    if (word == "--every-feeler") {
      line.options.every_feeler = true;
    } else if (std::ranges::find(kOwn, name) == kOwn.end()) {
      others.push_back(word);
    } else if (equals != std::string::npos) {
      read_own_option(line, name, word.substr(equals + 1));
    } else if (i + 1 < arguments.size()) {
      read_own_option(line, name, arguments[++i]);
    } else {
      line.errors.push_back(fmt::format("option '{}': expected a value after it", word));
    }
  }
  CommandLine picture = parse_command_line(others);
  if (picture.wish != CommandLine::Wish::render) {
    line.wish = StudyCommandLine::Wish::help;
    line.errors.clear();
    return line;
  }
  line.options.scene = std::move(picture.options);
  line.warnings = std::move(picture.warnings);
  line.errors.insert(line.errors.end(), picture.errors.begin(), picture.errors.end());
  if (!line.errors.empty()) return line;
  refuse_what_does_not_fit(line);
  if (line.options.folder.empty()) {
    line.options.folder = fmt::format("study-{}-{}x{}", std::filesystem::path(line.options.scene.scene).stem().string(),
                                      line.options.scene.width, line.options.scene.height);
  }
  return line;
}

std::string study_help_text() {
  std::string text =
      "Usage: firstlight study SCENE.pov [switches] [options]\n\n"
      "Renders a scene with every scheme and in the traditional order, and writes a report: an HTML page with plots\n"
      "and pictures, and the numbers as CSV files. Docs: docs/study.md.\n\n"
      "  --out DIR, -o DIR       The report's folder; default study-SCENE-WIDTHxHEIGHT\n"
      "  --schemes 'TEXT;TEXT'   Schemes and mixtures to compare, the first being what times are compared with\n"
      "  --rounds N              Rounds in which times are taken; default 3\n"
      "  --every-feeler          Every shadow feeler waits and is traced, as in the paper, also where its end can be\n"
      "                          foreseen\n"
      "Of the program's other options all that say what is rendered: +W, +H, +A, +L, declare=, --threads,\n"
      "--queue-memory (no limit if not given), --front-end, --quiet.\n\nSchemes, if none are given:\n";
  for (const std::string& scheme : all_study_schemes()) text += fmt::format("  {}\n", scheme);
  return text;
}

std::vector<std::string> all_study_schemes() {
  std::vector<std::string> schemes{std::string(kRecursive)};
  for (const priority::SchemeRow& row : priority::schemes()) {
    if (row.name != kRecursive) schemes.emplace_back(row.example);
  }
  schemes.emplace_back("0.7*contribution + 0.3*level");
  return schemes;
}

}  // namespace firstlight::app
