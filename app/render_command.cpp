#include "app/render_command.h"

#include "app/antialias.h"
#include "app/audience.h"
#include "app/boost_text.h"
#include "app/cockpit.h"
#include "app/ending.h"
#include "app/front_ends.h"
#include "app/load_scene.h"
#include "app/memory_size.h"
#include "app/output.h"
#include "app/picture_file.h"
#include "app/progress.h"
#include "app/snapshots.h"
#include "app/stats.h"
#include "parser/function_text.h"
#include "parser/parser.h"
#include "priority/driver.h"
#include "priority/order.h"
#include "render/accel/accel.h"
#include "render/image/link_target.h"
#include "render/math/interrupt.h"
#include "render/scene/scene.h"
#include "render/scene/scene_index.h"
#include "render/trace/medium_table.h"
#include "render/trace/radiance_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace firstlight::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

int fail(const std::string& why) {
  say_error(why);
  return kExitFailure;
}

int interrupted(Clock::time_point start) {
  say(fmt::format("firstlight: interrupted after {}; no picture written",
                  short_time(seconds_between(start, Clock::now()))));
  return kExitInterrupted;
}

/// Where files are to be written, before hours are spent on what goes into them. Empty, or what is wrong.
std::string check_outputs(const Options& options, const std::string& picture) {
  std::string problem;
  if (options.write_picture) problem = check_writable(picture);
  if (!problem.empty() || options.stats_file.empty()) return problem;
  std::error_code ignored;
  const auto place = [&](const std::string& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(render::link_target(file)), ignored);
  };
  if (options.write_picture && (place(options.stats_file) == place(picture) ||
                                std::filesystem::equivalent(options.stats_file, picture, ignored))) {
    return fmt::format("--stats: '{}' is where the picture is written", options.stats_file);
  }
  return check_writable(options.stats_file);
}

/// The scheme and the boosts that the user wants from the beginning.
std::optional<priority::Order> read_order(const Options& options, const priority::SchemeInput& input,
                                          std::string& error) {
  std::optional<priority::Order> order = priority::Order::parse(options.scheme, input, error);
  if (!order) {
    error = "--scheme: " + error;
    return std::nullopt;
  }
  for (const std::string& text : options.boosts) {
    const auto boost = parse_boost(text, order->boosts(), error);
    if (boost) error = order->add(*boost);
    if (!error.empty()) {
      error = fmt::format("--boost '{}': {}", text, error);
      return std::nullopt;
    }
  }
  return order;
}

priority::TraceOptions trace_options(const Options& options, const Stats& stats, const std::atomic<bool>& stop) {
  priority::TraceOptions out;
  out.threads = stats.threads;
  out.queue_memory = stats.queue_memory;
  out.stop = &stop;
  out.stop_at_error = options.stop_at_error;
  out.stop_after = options.stop_after;
  return out;
}

void take_over(const priority::TraceResult& traced, Clock::time_point start, Stats& stats) {
  stats.rays = traced.statistics;
  stats.trace = traced.statistics.seconds;
  stats.end = traced.end;
  const auto since_start = [&](const std::optional<Clock::time_point>& moment) {
    return moment ? std::optional(seconds_between(start, *moment)) : std::nullopt;
  };
  stats.preview = since_start(traced.statistics.preview);
  stats.first_image = since_start(traced.statistics.first_image);
}

}  // namespace

int render_command(const Options& options, Clock::time_point start, const std::atomic<bool>& stop) {
  const render::Interrupt interrupt(stop);
  const std::string picture = picture_path(options);
  if (const std::string problem = check_outputs(options, picture); !problem.empty()) return fail(problem);

  std::string problem;
  // Declared before everything the scene is kept in: the module has to live longer than its scene.
  const ChosenFrontEnd front_end(options.front_end);
  if (!front_end.error().empty()) return fail(front_end.error());
  std::unique_ptr<SteerServer> server;
  if (!options.steer.empty()) {
    server = SteerServer::open(options.steer, problem);
    if (server == nullptr) return fail("--steer: " + problem);
  }
  ProgressLine line(options.quiet);
  Stats stats;
  stats.scene = options.scene;
  stats.scheme = options.scheme;
  const int processors = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  stats.threads = options.threads > 0 ? options.threads : processors;
  stats.width = options.width;
  stats.height = options.height;
  stats.queue_memory = options.queue_memory > 0 ? options.queue_memory : default_queue_memory();

  line.stage("reading the scene");
  const auto parse_begin = Clock::now();
  const render::LoadResult loaded = load_scene(options, *front_end, line, &stop);
  stats.parse = seconds_between(parse_begin, Clock::now());
  if (loaded.scene == nullptr) return stop ? kExitInterrupted : kExitFailure;
  const render::Scene& scene = *loaded.scene;
  stats.remaining_is_bound = render::RadianceBound(scene).known();
  render::Film film(options.width, options.height);
  std::optional<priority::Order> order = read_order(
      options, {render::index_of(scene), options.width, options.height, parser::compile_text, &film}, problem);
  if (!order) {
    say_error_in_lines(problem);
    return kExitFailure;
  }

  if (stop) return interrupted(start);

  line.stage("building the hierarchy");
  const auto build_begin = Clock::now();
  const render::Accel accel(scene);
  stats.build = seconds_between(build_begin, Clock::now());
  if (stop) return interrupted(start);

  render::MediumTable media;
  const auto write = [&](const std::string& file) -> std::string {
    if (file.empty() && !options.write_picture) return "no picture is to be written (-F)";
    return write_film(file.empty() ? picture : file, film, scene.settings);
  };
  priority::Steering steering(std::move(*order));
  Desk desk(steering);
  Audience audience(line, steering, desk, write);
  std::optional<Snapshots> snapshots;
  if (!options.snapshots_folder.empty()) {
    snapshots.emplace(options.snapshots_folder, film, scene.settings);
    if (!snapshots->error().empty()) return fail(snapshots->error());
    audience.take_snapshots(*snapshots);
  }
  priority::TraceOptions tracing = trace_options(options, stats, stop);
  const std::optional<render::AntialiasSettings> antialias = antialias_of(options, scene.settings);
  if (antialias) tracing.antialias = &*antialias;
  tracing.steering = &steering;
  tracing.observer = &audience;
  priority::TraceResult traced;
  {
    const bool keys = !options.quiet && options.steer != "-" && line.is_shown() && RawTerminal::exists();
    const Cockpit cockpit(steering, desk, line, std::move(server), keys);
    traced = priority::trace({scene, accel, media}, film, tracing);
    desk.serve(write);  // who asked in the last moment
  }
  line.clear();
  if (!traced.error.empty()) return fail(traced.error);
  if (stop && !traced.complete()) return interrupted(start);
  take_over(traced, start, stats);
  stats.scheme = steering.order().text();

  // The picture first: what goes wrong with the rest costs an exit code, no more.
  if (options.write_picture) {
    if (problem = write(""); !problem.empty()) return fail(problem);
  }
  stats.total = seconds_between(start, Clock::now());
  int exit_code = 0;
  const auto note = [&](const std::string& why) {
    if (!why.empty()) exit_code = fail(why);
  };
  if (snapshots) {
    snapshots->finished(stats.rays);
    note(snapshots->error());
  }
  if (!options.stats_file.empty()) note(write_text_file(options.stats_file, to_json(stats)));
  if (!options.quiet) say(summary(options, picture, stats));
  return exit_code;
}

}  // namespace firstlight::app
