#include "app/compare/programs.h"

#include "app/compare/workplace.h"
#include "app/pov_switches.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

/// Switches that both programs understand. Later ones count; where files go, and that nobody looks on, is ours to say.
std::vector<std::string> switches(const SceneJob& job, const CompareSettings& settings, const Workplace& place) {
  std::vector<std::string> words{"+W320", "+H240", "-A", "-J"};
  for (const fs::path& library : place.libraries()) words.push_back("+L" + library.string());
  if (job.ini) words.push_back(job.ini->string());
  if (settings.width > 0) words.push_back(fmt::format("+W{}", settings.width));
  if (settings.height > 0) words.push_back(fmt::format("+H{}", settings.height));
  for (const std::string& word : settings.words) words.push_back(place.placed(word));
  words.push_back(fmt::format("+WT{}", settings.threads));
  for (const char* word : {"+FN", "-D", "-P"}) words.emplace_back(word);
  words.push_back("+I" + place.scene().string());
  return words;
}

ProcessResult run(const Workplace& place, const CompareSettings& settings, std::vector<std::string> words) {
  ProcessResult failed;
  failed.error = place.error();
  if (!failed.error.empty()) return failed;
  Command command;
  command.words = std::move(words);
  command.folder = place.folder();
  command.home = place.home();
  command.limit = settings.time_limit;
  command.stop = settings.stop;
  return run_process(command);
}

std::string firstlight_program(const CompareSettings& settings) {
  return settings.firstlight.empty() ? "/proc/self/exe" : settings.firstlight.string();
}

/// Why there is no picture; empty when there is one. `said`: what the program itself has to say of it.
std::string failure(const ProcessResult& process, const fs::path& picture, const CompareSettings& settings,
                    const std::string& said) {
  std::error_code ignored;
  if (!process.error.empty()) return process.error;
  if (process.timed_out) return fmt::format("no picture within the time limit of {} s", settings.time_limit.count());
  if (process.signal != 0 || process.stopped) return process.summary();
  if (process.exit_code != 0) return said.empty() ? process.summary() : said;
  return fs::exists(picture, ignored) ? "" : "it wrote no picture";
}

SceneRun finished(ProcessResult process) {
  SceneRun result;
  result.times.wall = process.seconds;
  result.times.processor = process.processor;
  result.times.peak_bytes = process.peak_kilobytes * 1024;
  result.process = std::move(process);
  return result;
}

/// A word as POV-Ray reads it: it takes a blank for the end of a value, even within a word, unless quotes are around it.
std::string quoted(const std::string& word) {
  if (word.find(' ') == std::string::npos) return word;
  std::size_t value = word.find('=') + 1;  // 0 where there is none: the whole word
  if (word[0] == '+' || word[0] == '-') {
    const SwitchRow* const row = find_switch(std::string_view(word).substr(1));
    value = row != nullptr ? 1 + row->letters.size() : 0;
  }
  const char mark = word.find('"') == std::string::npos ? '"' : '\'';
  return word.substr(0, value) + mark + word.substr(value) + mark;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// POV-Ray breaks its lines: before a blank, which begins the next one, or within a word that fills the line. A message
/// may fill its line, too; then the next one is known by its first words.
std::vector<std::string> unbroken_lines(std::string_view text) {
  constexpr std::size_t kWidth = 79;
  const auto begins_message = [](std::string_view line) {
    return line.starts_with("File '") || line.starts_with("Fatal error") || line.starts_with("Render failed");
  };
  std::vector<std::string> lines;
  std::size_t last = 0;  // length of the line before
  for (const std::string& line : lines_of(text)) {
    if (!lines.empty() && !line.empty() &&
        ((last >= kWidth && !begins_message(line)) || (line[0] == ' ' && last > kWidth / 2))) {
      lines.back() += line;
    } else {
      lines.push_back(line);
    }
    last = line.size();
  }
  return lines;
}

}  // namespace

SceneRun run_povray(const SceneJob& job, const CompareSettings& settings, const fs::path& picture) {
  const Workplace place(job);
  std::vector<std::string> words = switches(job, settings, place);
  words.insert(words.begin(), settings.povray);
  words.emplace_back("+GA");  // its times, also when an .ini file wants no messages
  words.push_back("+O" + picture.string());
  std::ranges::transform(words.begin() + 1, words.end(), words.begin() + 1, quoted);
  std::error_code ignored;
  fs::remove(picture, ignored);
  SceneRun result = finished(run(place, settings, words));
  const std::string printed = result.process.out + result.process.err;
  result.error = failure(result.process, picture, settings, povray_error(printed));
  result.times.parse = povray_seconds("Parse Time:", printed) + povray_seconds("Bounding Time:", printed);
  for (const char* label : {"Photon Time:", "Radiosity Time:", "Trace Time:"}) {
    result.times.trace += povray_seconds(label, printed);
  }
  return result;
}

SceneRun run_firstlight(const SceneJob& job, const CompareSettings& settings, const fs::path& picture) {
  const fs::path statistics = picture.string() + ".json";
  const Workplace place(job);
  std::vector<std::string> words = switches(job, settings, place);
  words.insert(words.begin(), firstlight_program(settings));
  words.insert(words.end(), settings.our_words.begin(), settings.our_words.end());
  for (const std::string& word : {"+O" + picture.string(), "--stats=" + statistics.string(), std::string("--quiet")}) {
    words.push_back(word);
  }
  std::error_code ignored;
  fs::remove(picture, ignored);
  SceneRun result = finished(run(place, settings, words));
  result.error = failure(result.process, picture, settings, firstlight_error(result.process.err));
  if (!result.error.empty()) return result;
  std::ifstream stream(statistics);
  const auto stats = nlohmann::json::parse(stream, nullptr, false);
  const auto time = [&](const char* name) {
    const nlohmann::json::json_pointer place("/time/" + std::string(name));
    return stats.contains(place) && stats.at(place).is_number() ? stats.at(place).get<double>() : 0.0;
  };
  result.times.parse = time("parse_s") + time("build_s");
  result.times.trace = time("trace_s");
  return result;
}

std::vector<MissingFeature> missing_features(const SceneJob& job, const CompareSettings& settings) {
  const Workplace place(job);
  std::vector<std::string> words = switches(job, settings, place);
  words.insert(words.begin(), firstlight_program(settings));
  words.insert(words.end(), settings.our_words.begin(), settings.our_words.end());
  for (const char* word : {"--parse-only", "--json", "--quiet"}) words.emplace_back(word);
  std::vector<MissingFeature> missing;
  const auto json = nlohmann::json::parse(run(place, settings, words).out, nullptr, false);
  if (!json.is_object() || !json.contains("unrendered")) return missing;
  for (const auto& entry : json["unrendered"]) {
    missing.push_back(
        {entry.value("feature", ""), entry.value("file", ""), entry.value("line", 0), entry.value("column", 0)});
  }
  return missing;
}

double povray_seconds(std::string_view label, std::string_view printed) {
  const std::size_t at = printed.rfind(label);  // the last: a scene may print what it likes before
  if (at == std::string_view::npos) return 0.0;
  const std::string_view line = printed.substr(at, printed.find('\n', at) - at);
  const std::size_t number = line.find('(');
  double seconds = 0.0;
  if (number != std::string_view::npos) std::from_chars(line.data() + number + 1, line.data() + line.size(), seconds);
  return seconds;
}

std::string povray_error(std::string_view printed) {
  const std::vector<std::string> lines = unbroken_lines(printed);
  // The marks go from the one that says most to the one that only says that it failed.
  for (const std::string_view mark : {"Parse Error: ", "Fatal error", "Failed to", "Cannot", "rror: "}) {
    for (const std::string& line : lines) {
      if (line.find(mark) != std::string::npos && line.find("Possible Parse Error") == std::string::npos) {
        return line;
      }
    }
  }
  return {};
}

std::string firstlight_error(std::string_view printed) {
  constexpr std::string_view kOwnName = "firstlight: error: ";  // where no place in a file is to blame
  for (const std::string& line : lines_of(printed)) {
    if (line.starts_with(kOwnName)) return line.substr(kOwnName.size());
    if (line.find("error: ") != std::string::npos) return line;
  }
  return {};
}

}  // namespace firstlight::app::compare
