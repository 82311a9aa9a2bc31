#include "app/study/command.h"

#include "app/antialias.h"
#include "app/command_text.h"
#include "app/front_ends.h"
#include "app/load_scene.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/render_command.h"
#include "app/study/measure.h"
#include "app/study/options.h"
#include "app/study/report_folder.h"
#include "parser/function_text.h"
#include "parser/parser.h"
#include "priority/order.h"
#include "render/math/interrupt.h"
#include "render/scene/file_encoding.h"
#include "render/scene/scene_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>

namespace firstlight::app {
namespace {

int fail(const std::string& why) {
  say_error(why);
  return kExitFailure;
}

int interrupted() {
  say("firstlight: interrupted; no report written");
  return kExitInterrupted;
}

/// Fills plan.schemes. Empty, or what is wrong with one of the texts.
std::string choose_schemes(const StudyOptions& options, StudyPlan& plan) {
  const std::vector<std::string> texts = options.schemes.empty() ? all_study_schemes() : options.schemes;
  priority::SchemeInput input;
  input.scene = render::index_of(*plan.scene);
  input.width = plan.width;
  input.height = plan.height;
  input.compile = parser::compile_text;
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
  const render::Interrupt interrupt(stop);
  const StudyCommandLine line = parse_study_command_line(arguments);
  if (line.wish == StudyCommandLine::Wish::help) {
    const std::string problem = print_result(study_help_text());
    return problem.empty() ? 0 : fail(problem);
  }
  for (const std::string& error : line.errors) say_error(error);
  if (!line.errors.empty()) return kExitFailure;
  const Options& options = line.options.scene;
  for (const std::string& warning : line.warnings) {
    if (!options.quiet) say_warning(warning);
  }

  // Declared before everything the scene is kept in: the module has to live longer than its scene.
  const ChosenFrontEnd front_end(options.front_end);
  if (!front_end.error().empty()) return fail(front_end.error());
  ProgressLine progress(options.quiet);
  progress.stage("reading the scene");
  const render::LoadResult loaded = load_scene(options, *front_end, progress, &stop);
  if (loaded.scene == nullptr) return stop ? kExitInterrupted : kExitFailure;
  const render::Accel accel(*loaded.scene,
                            line.options.every_feeler ? render::Foresight::none : render::Foresight::some);
  if (stop) return interrupted();

  StudyPlan plan;
  plan.scene = loaded.scene.get();
  plan.accel = &accel;
  plan.width = options.width;
  plan.height = options.height;
  plan.threads =
      options.threads > 0 ? options.threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  plan.queue_memory = options.queue_memory;
  plan.antialias = antialias_of(options, plan.scene->settings);
  plan.rounds = line.options.rounds;
  plan.stop = &stop;
  plan.say = [&](const std::string& what) { progress.stage(what); };
  if (const std::string problem = choose_schemes(line.options, plan); !problem.empty()) {
    say_error_in_lines(problem);
    return kExitFailure;
  }

  ReportFolder folder(line.options.folder, plan.width, plan.height, render::file_encoding(plan.scene->settings));
  if (const std::string problem = folder.prepare(); !problem.empty()) return fail(problem);
  plan.keep_picture = [&](std::size_t scheme, double share, std::span<const render::Rgb> colors) {
    return folder.keep_picture(scheme, plan.schemes[scheme].text, share, colors);
  };

  Study study;
  study.scene = std::filesystem::path(options.scene).filename().string();
  study.command = command_text("firstlight study", arguments);
  std::string problem = measure(plan, study);
  progress.clear();
  if (stop) return interrupted();
  if (problem.empty()) problem = folder.error();
  if (problem.empty()) problem = folder.write(study);
  if (!problem.empty()) return fail(problem);
  if (!options.quiet) say(folder.page() + ": the report, CSV files beside it");
  return 0;
}

}  // namespace firstlight::app
