#include "app/render_command.h"

#include "app/front_ends.h"
#include "app/picture_file.h"
#include "app/progress.h"
#include "app/snapshots.h"
#include "app/stats.h"
#include "parser/parser.h"
#include "priority/driver.h"
#include "priority/order.h"
#include "render/accel/accel.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

namespace firstlight::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void say(const std::string& text) { fmt::print(stderr, "{}\n", text); }

int fail(const std::string& why) {
  say("firstlight: error: " + why);
  return kExitFailure;
}

/// Passes what happens on to the progress line and to the snapshots, if there are any.
struct Audience final : priority::Observer {
  explicit Audience(ProgressLine& progress_line) : line(progress_line) {}

  void progress(const priority::Progress& progress) override { line.progress(progress); }
  void key_changed(const priority::Progress& progress) override {
    if (snapshots) snapshots->key_changed(progress);
  }
  void first_image(const priority::Progress& progress) override {
    if (snapshots) snapshots->first_image(progress);
  }

  ProgressLine& line;
  std::optional<Snapshots> snapshots;
};

/// Reads the scene and shows what the front end has to say about it.
render::LoadResult load(const Options& options, const render::FrontEnd& front_end, ProgressLine& line) {
  render::LoadOptions load;
  load.width = options.width;
  load.height = options.height;
  load.library_paths = options.library_paths;
  load.declares = options.declares;
  load.clock = options.clock;
  std::size_t shown = 0;
  const auto show = [&](const render::Diagnostic& diagnostic) {
    ++shown;
    if (options.quiet && diagnostic.severity != render::Diagnostic::Severity::error) return;
    line.clear();
    say(render::format(diagnostic));
  };
  load.report = show;
  render::LoadResult result = front_end.load(options.scene, load);
  // A front end of another making may not report as it reads.
  for (std::size_t i = shown; i < result.diagnostics.size(); ++i) show(result.diagnostics[i]);
  return result;
}

/// Where files are to be written, before hours are spent on what goes into them. Empty, or what is wrong.
std::string check_outputs(const Options& options, const std::string& picture) {
  std::string problem;
  if (options.write_picture) problem = check_writable(picture);
  if (problem.empty() && !options.stats_file.empty()) problem = check_writable(options.stats_file);
  return problem;
}

// Half of the machine's memory: the rest is for the scene, the film and others.
std::size_t default_queue_budget() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_size = sysconf(_SC_PAGESIZE);
  return pages > 0 && page_size > 0 ? static_cast<std::size_t>(pages) / 2 * static_cast<std::size_t>(page_size) : 0;
}

int interrupted(Clock::time_point start) {
  say(fmt::format("firstlight: interrupted after {}; no picture written", short_time(seconds_since(start))));
  return kExitInterrupted;
}

std::string summary(const Options& options, const std::string& picture, const Stats& stats) {
  std::string text = options.write_picture ? picture : "no picture written";
  text += fmt::format(": {} x {}, {} rays, trace {}, total {}", stats.width, stats.height,
                      short_count(stats.rays.rays.total()), short_time(stats.trace), short_time(stats.total));
  if (stats.first_image) text += fmt::format(", first image after {}", short_time(*stats.first_image));
  return text;
}

}  // namespace

int render_command(const Options& options, Clock::time_point start, const std::atomic<bool>& stop) {
  const std::string picture = picture_path(options);
  if (const std::string problem = check_outputs(options, picture); !problem.empty()) return fail(problem);

  // Declared before everything the scene is kept in: the module has to live longer than its scene.
  std::unique_ptr<FrontEndModule> module;
  const parser::PovFrontEnd pov;
  const render::FrontEnd* front_end = &pov;
  if (!options.front_end.empty()) {
    std::string problem;
    module = FrontEndModule::open(options.front_end, problem);
    if (module == nullptr) return fail(problem);
    front_end = &module->front_end();
  }
  ProgressLine line(options.quiet);
  Stats stats;
  stats.scene = options.scene;
  stats.scheme = options.scheme;
  stats.threads =
      options.threads > 0 ? options.threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  stats.width = options.width;
  stats.height = options.height;

  line.stage("reading the scene");
  const auto parse_begin = Clock::now();
  const render::LoadResult loaded = load(options, *front_end, line);
  stats.parse = seconds_since(parse_begin);
  if (loaded.scene == nullptr) return kExitFailure;
  const render::Scene& scene = *loaded.scene;

  if (stop) return interrupted(start);

  line.stage("building the hierarchy");
  const auto build_begin = Clock::now();
  const render::Accel accel(scene);
  stats.build = seconds_since(build_begin);

  render::MediumTable media;
  render::Film film(options.width, options.height);
  Audience audience(line);
  if (!options.snapshots_folder.empty()) {
    audience.snapshots.emplace(options.snapshots_folder, film, scene.settings);
    if (!audience.snapshots->error().empty()) return fail(audience.snapshots->error());
  }
  std::string problem;
  const std::optional<priority::Order> order =
      priority::Order::parse(options.scheme, {&scene, options.width, options.height}, problem);
  if (!order) return fail("--scheme: " + problem);
  const std::shared_ptr<const priority::Scheme> scheme = order->scheme();
  priority::TraceOptions trace_options;
  trace_options.scheme = scheme.get();
  trace_options.threads = stats.threads;
  trace_options.queue_budget = default_queue_budget();
  trace_options.observer = &audience;
  trace_options.stop = &stop;
  const priority::TraceResult traced = priority::trace({scene, accel, media}, film, trace_options);
  line.clear();
  if (!traced.error.empty()) return fail(traced.error);
  if (!traced.complete) return interrupted(start);
  stats.rays = traced.statistics;
  stats.trace = traced.statistics.seconds;
  if (traced.statistics.first_image) {
    stats.first_image = std::chrono::duration<double>(*traced.statistics.first_image - start).count();
  }

  if (audience.snapshots) {
    audience.snapshots->finished(stats.trace, stats.rays.rays.total());
    if (!audience.snapshots->error().empty()) return fail(audience.snapshots->error());
  }
  if (options.write_picture) {
    if (const std::string problem = write_film(picture, film, scene.settings); !problem.empty()) return fail(problem);
  }
  stats.total = seconds_since(start);
  if (!options.stats_file.empty()) {
    if (const std::string problem = write_text_file(options.stats_file, to_json(stats)); !problem.empty()) {
      return fail(problem);
    }
  }
  if (!options.quiet) say(summary(options, picture, stats));
  return 0;
}

}  // namespace firstlight::app
