#include "app/compare/list_command.h"

#include "app/command_text.h"
#include "app/compare/agreement.h"
#include "app/compare/command.h"
#include "app/compare/compare_scene.h"
#include "app/compare/kept.h"
#include "app/compare/list.h"
#include "app/compare/list_options.h"
#include "app/compare/programs.h"
#include "app/compare/record_json.h"
#include "app/compare/report/report.h"
#include "app/compare/sweep.h"
#include "app/compare/sweep_json.h"
#include "app/compare/totals.h"
#include "app/exit_code.h"
#include "app/output.h"
#include "app/picture_file.h"
#include "app/progress.h"
#include "app/stats.h"
#include "render/scene/escaped.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A folder's scenes are called by their paths below it; with several folders and scenes each has its own before it.
SceneList scenes_of(const ListCommandLine& line) {
  if (!line.list.empty()) {
    const fs::path folder = line.list.has_parent_path() ? line.list.parent_path() : fs::path(".");
    return read_list(line.list, line.root.empty() ? folder : line.root);
  }
  SceneList all;
  const bool is_one = line.common.subjects.size() == 1;
  for (const std::string& subject : line.common.subjects) {
    std::error_code ignored;
    const bool is_folder = fs::is_directory(subject, ignored);
    SceneList list = is_folder ? find_scenes(subject)
                               : parse_list(fmt::format("\"{}\"", fs::path(subject).filename().string()), subject,
                                            fs::absolute(subject).parent_path());
    for (ListedScene& scene : list.scenes) {
      if (!is_one && is_folder) scene.name = (fs::path(subject).lexically_normal() / scene.name).string();
      if (line.common.ini) scene.ini = line.common.ini;
      all.scenes.push_back(std::move(scene));
    }
    std::ranges::move(list.errors, std::back_inserter(all.errors));
  }
  return all;
}

std::string title_of(const ListCommandLine& line) {
  if (!line.list.empty()) return line.list.stem().string();
  if (line.common.subjects.size() > 1) return fmt::format("{} scenes", line.common.subjects.size());
  fs::path subject = fs::absolute(line.common.subjects[0]).lexically_normal();
  if (!subject.has_filename()) subject = subject.parent_path();
  return subject.stem().string();
}

/// A scene's outcome, in one line.
std::string line_of(const SceneRecord& record) {
  std::string text = fmt::format("{}: {}", record.name, status_text(record.status));
  if (record.difference) text += fmt::format(", {:.2f} %", 100.0 * record.difference->share);
  const auto ratio = trace_ratio(record);
  if (ratio) text += fmt::format(", tracing {:.2f} times as fast", *ratio);
  if (!record.missing.empty()) {
    std::set<std::string_view> features;
    for (const MissingFeature& missing : record.missing) features.insert(missing.feature);
    const char* between = ": ";
    for (const std::string_view feature : features) text += fmt::format("{}{}", std::exchange(between, ", "), feature);
  } else if (!record.message.empty()) {
    text += ": " + record.message.substr(0, record.message.find('\n'));
  }
  return text;
}

/// The line that says how far it is, and a line for each scene that is done.
class Watcher {
 public:
  Watcher(std::size_t all, bool quiet, bool shows_scenes) : all_(all), shows_scenes_(shows_scenes), line_(quiet) {}

  void begins(const std::string& name) {
    running_.insert(name);
    show();
  }
  void ends(const SceneRecord& record, bool kept) {
    running_.erase(running_.find(record.name));
    ++done_;
    if (!kept) ++rendered_;
    if (record.status == Status::agrees) ++agree_;
    if (shows_scenes_) {
      line_.clear();
      if (problem_.empty()) problem_ = print_result(render::escaped(line_of(record)) + "\n");
    }
    show();
  }
  void clear() { line_.clear(); }
  /// Why the lines could not be written; empty when they were.
  const std::string& problem() const { return problem_; }

 private:
  void show() {
    std::string text = fmt::format("{} of {}, {} agree", done_, all_, agree_);
    if (rendered_ > 0) {
      // As long as the scenes so far took; what was kept takes no time.
      const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
      const double left = seconds / static_cast<double>(rendered_) * static_cast<double>(all_ - done_);
      text += fmt::format(", about {} left", short_time(left));
    }
    for (const std::string& name : running_) text += "; " + name;
    line_.stage(text);
  }

  const std::size_t all_;
  const bool shows_scenes_;
  const Clock::time_point begin_ = Clock::now();
  ProgressLine line_;
  std::size_t done_ = 0;
  std::size_t rendered_ = 0;
  std::size_t agree_ = 0;
  std::multiset<std::string> running_;
  std::string problem_;
};

/// Finds out before hours of rendering whether all outputs can be written. Empty, or what is wrong.
std::string check_outputs(const ListCommandLine& line) {
  std::string why;
  if (!line.report.empty()) why = check_report_folder(line.report);
  for (const fs::path& file : {line.agreement, line.json}) {
    if (why.empty() && !file.empty()) why = check_writable(file.string());
  }
  return why;
}

std::string write_outputs(const ListCommandLine& line, const std::vector<SceneRecord>& records,
                          const std::string& command) {
  std::string why;
  if (!line.report.empty()) why = write_report(line.report, {records, title_of(line), command});
  if (why.empty() && !line.agreement.empty()) {
    why = write_text_file(line.agreement.string(), agreement_page(records, command));
  }
  if (why.empty() && !line.json.empty()) why = write_text_file(line.json.string(), text_of(sweep_json(records)));
  if (why.empty() && !line.report.empty() && !line.common.quiet) {
    say(fmt::format("{}: the report", (line.report / "index.html").string()));
  }
  return why;
}

/// The worst of the scenes'.
int exit_code_of(const std::vector<SceneRecord>& records) {
  int worst = 0;
  for (const SceneRecord& record : records) worst = std::max(worst, exit_code(record.status));
  return worst;
}

SweepPlan plan_of(const ListCommandLine& line, std::vector<ListedScene> scenes, const std::atomic<bool>& stop,
                  Watcher& watcher) {
  SweepPlan plan;
  plan.scenes = std::move(scenes);
  plan.settings = line.common.settings;
  plan.settings.stop = &stop;
  plan.own_thresholds = !line.common.settings.thresholds.share && !line.common.settings.thresholds.psnr;
  plan.jobs = line.jobs;
  plan.cache = line.cache.empty() ? default_cache() : line.cache;
  plan.again = line.again;
  plan.povray_too = line.povray_too;
  plan.compare = compare_scene;
  plan.missing = missing_features;
  plan.begins = [&watcher](const std::string& name) { watcher.begins(name); };
  plan.ends = [&watcher](const SceneRecord& record, bool kept) { watcher.ends(record, kept); };
  return plan;
}

int sweep_scenes(const ListCommandLine& line, std::vector<ListedScene> scenes, const std::string& command,
                 const std::atomic<bool>& stop) {
  const std::size_t all = scenes.size();
  Watcher watcher(all, line.common.quiet, !line.common.quiet && !line.common.json);
  const SweepResult result = sweep(plan_of(line, std::move(scenes), stop, watcher));
  watcher.clear();
  const std::vector<SceneRecord>& records = result.records;
  std::string problem = watcher.problem();
  if (problem.empty() && !line.common.json && !records.empty()) {
    std::string text = "\n" + to_text(totals(records));
    if (result.kept > 0) text += fmt::format("{} of them done before; --again renders them anew\n", result.kept);
    problem = print_result(text);
  }
  if (!result.error.empty()) return fail(result.error);
  if (result.stopped) {
    return interrupted(
        fmt::format(": {} of {} scenes are done; the same command goes on with the others", records.size(), all));
  }
  if (line.common.json) problem = print_result(text_of(sweep_json(records)));
  if (const std::string why = write_outputs(line, records, command); !why.empty()) return fail(why);
  if (!problem.empty()) return fail(problem);
  return exit_code_of(records);
}

}  // namespace

std::optional<int> compare_list_command(std::span<const std::string> arguments, const std::atomic<bool>& stop) {
  ListCommandLine line = parse_list_command_line(arguments);
  if (!line.is_asked_for) return std::nullopt;
  for (const std::string& error : line.common.errors) fail(error);
  if (!line.common.errors.empty()) return kExitUnreadable;
  SceneList list = scenes_of(line);
  constexpr std::size_t kMostErrors = 20;
  for (const std::string& error : std::span(list.errors).first(std::min(list.errors.size(), kMostErrors))) fail(error);
  if (!list.errors.empty()) return kExitUnreadable;
  if (const std::string why = check_povray(line.common.settings); !why.empty()) return fail(why);
  line.common.settings.povray = find_program(line.common.settings.povray)->string();
  if (const std::string why = check_outputs(line); !why.empty()) return fail(why);
  return sweep_scenes(line, std::move(list.scenes), command_text("firstlight compare", arguments), stop);
}

std::string list_help_text() {
  return "\nMany scenes:\n"
         "       firstlight compare FOLDER | --list FILE | SCENE.pov ... [switches] [options]\n\n"
         "Goes through the scenes, each from its own folder, and tells totals at the end. What is done is kept, and "
         "not done\n"
         "again by the same command. A list names a scene a line, perhaps with an .ini file and switches behind it.\n\n"
         "  --root DIR              What a list's names are relative to; default: the list's folder\n"
         "  --jobs N                So many scenes at a time; default 1. Times are then worth less\n"
         "  --cache DIR             Where results and POV-Ray's pictures are kept; default: the user's cache folder\n"
         "  --again                 Render anew with Firstlight what was done before\n"
         "  --povray-too            Have POV-Ray render also what Firstlight lacks features for\n"
         "  --report DIR            Write a report to look at: open its index.html\n"
         "  --agreement FILE.md     Write a table of all scenes\n"
         "  --json, --json=FILE     Say everything as JSON\n"
         "The exit status is the worst of the scenes'.\n";
}

}  // namespace firstlight::app::compare
