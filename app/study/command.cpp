#include "app/study/command.h"

#include "app/command_text.h"
#include "app/exit_code.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/session.h"
#include "app/study/measure.h"
#include "app/study/options.h"
#include "app/study/report_folder.h"
#include "priority/order.h"
#include "render/scene/file_encoding.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <utility>

namespace firstlight::app {
namespace {

/// Fills plan.schemes. Empty, or what is wrong with one of the texts.
std::string choose_schemes(const StudyOptions& options, StudyPlan& plan) {
  const std::vector<std::string> texts = options.schemes.empty() ? all_study_schemes() : options.schemes;
  const priority::SchemeInput input = plan.session->scheme_input(nullptr);
  for (const std::string& text : texts) {
    std::string problem;
    const auto order = priority::Order::parse(text, input, problem);
    if (!order) return fmt::format("scheme '{}': {}", text, problem);
    plan.schemes.push_back({text, [text, input](const render::Film& film) {
                              priority::SchemeInput own = input;
                              own.film = &film;
                              std::string none;
                              return priority::Order::parse(text, own, none)->scheme();
                            }});
  }
  return {};
}

}  // namespace

int study_command(std::span<const std::string> arguments, const std::atomic<bool>& stop) {
  const StudyCommandLine line = parse_study_command_line(arguments);
  if (line.wish == StudyCommandLine::Wish::help) {
    return print(study_help_text());
  }
  for (const std::string& error : line.errors) say_error(error);
  if (!line.errors.empty()) return kExitFailure;
  const Options& options = line.options.scene;
  for (const std::string& warning : line.warnings) {
    if (!options.quiet) say_warning(warning);
  }

  ProgressLine progress(options.quiet);
  Session session(options, progress, stop);
  if (!session.error().empty()) return fail(session.error());
  if (!session.load()) return session.exit_code();
  session.build(line.options.every_feeler ? render::Foresight::none : render::Foresight::some);
  if (stop) return interrupted("; no report written");

  StudyPlan plan;
  plan.session = &session;
  plan.rounds = line.options.rounds;
  plan.say = [&](const std::string& what) { progress.stage(what); };
  if (const std::string problem = choose_schemes(line.options, plan); !problem.empty()) {
    say_error_in_lines(problem);
    return kExitFailure;
  }

  ReportFolder folder(line.options.folder, options.width, options.height,
                      render::file_encoding(session.scene().settings));
  if (const std::string problem = folder.prepare(); !problem.empty()) return fail(problem);
  plan.keep_picture = [&](std::size_t scheme, double share, std::span<const render::Rgb> colors) {
    return folder.keep_picture(scheme, plan.schemes[scheme].text, share, colors);
  };

  Study study;
  study.scene = std::filesystem::path(options.scene).filename().string();
  study.command = command_text("firstlight study", arguments);
  std::string problem = measure(plan, study);
  progress.clear();
  if (stop) return interrupted("; no report written");
  if (problem.empty()) problem = folder.error();
  if (problem.empty()) problem = folder.write(study);
  if (!problem.empty()) return fail(problem);
  if (!options.quiet) say(folder.page() + ": the report, CSV files beside it");
  return 0;
}

}  // namespace firstlight::app
