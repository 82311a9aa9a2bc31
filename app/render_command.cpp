#include "app/render_command.h"

#include "app/audience.h"
#include "app/boost_text.h"
#include "app/cockpit.h"
#include "app/ending.h"
#include "app/exit_code.h"
#include "app/memory_size.h"
#include "app/output.h"
#include "app/picture_file.h"
#include "app/session.h"
#include "app/snapshots.h"
#include "app/stats.h"
#include "app/steer_server.h"
#include "app/terminal_keys.h"
#include "priority/order.h"
#include "render/image/link_target.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace firstlight::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

int interrupted_since(Clock::time_point start) {
  return interrupted(fmt::format(" after {}; no picture written", short_time(seconds_between(start, Clock::now()))));
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

/// Who steers from elsewhere, as `options.steer` says. `problem` says why that cannot be.
std::vector<std::unique_ptr<Control>> open_controls(const Options& options, std::string& problem) {
  std::vector<std::unique_ptr<Control>> controls;
  if (options.steer.empty()) return controls;
  controls.push_back(SteerServer::open(options.steer, problem));
  if (!problem.empty()) problem = "--steer: " + problem;
  return controls;
}

priority::TraceOptions trace_options(const Options& options, const Session& session) {
  priority::TraceOptions out = session.trace_options();
  if (options.queue_memory == 0) out.queue_memory = default_queue_memory();
  return out;
}

Stats stats_of(const Options& options, const Session& session, const priority::TraceOptions& tracing,
               const priority::TraceResult& traced, Clock::time_point start) {
  Stats stats;
  stats.scene = options.scene;
  stats.scheme = tracing.steering->order().text();
  stats.threads = tracing.threads;
  stats.width = options.width;
  stats.height = options.height;
  stats.queue_memory = tracing.queue_memory;
  stats.parse = session.parse_seconds();
  stats.build = session.build_seconds();
  stats.rays = traced.statistics;
  stats.trace = traced.statistics.seconds;
  stats.end = traced.end;
  const auto since_start = [&](const std::optional<Clock::time_point>& moment) {
    return moment ? std::optional(seconds_between(start, *moment)) : std::nullopt;
  };
  stats.preview = since_start(traced.statistics.preview);
  stats.first_image = since_start(traced.statistics.first_image);
  return stats;
}

}  // namespace

int render_command(const Options& options, Clock::time_point start, const std::atomic<bool>& stop) {
  const std::string picture = picture_path(options);
  std::string problem = check_outputs(options, picture);
  if (!problem.empty()) return fail(problem);
  ProgressLine line(options.quiet);
  Session session(options, line, stop);
  if (!session.error().empty()) return fail(session.error());
  std::vector<std::unique_ptr<Control>> controls = open_controls(options, problem);
  if (!problem.empty()) return fail(problem);

  if (!session.load()) return session.exit_code();
  render::Film film(options.width, options.height, options.alpha);
  std::optional<priority::Order> order = read_order(options, session.scheme_input(&film), problem);
  if (!order) {
    say_error_in_lines(problem);
    return kExitFailure;
  }
  if (stop) return interrupted_since(start);
  session.build();
  if (stop) return interrupted_since(start);

  const auto write = [&](const std::string& file) -> std::string {
    if (file.empty() && !options.write_picture) return "no picture is to be written (-F)";
    return session.write(file.empty() ? picture : file, film);
  };
  priority::Steering steering(std::move(*order));
  Desk desk(steering, write);
  LineReader line_reader(line, steering);
  std::vector<priority::Observer*> observers{&desk, &line_reader};
  std::optional<Snapshots> snapshots;
  if (!options.snapshots_folder.empty()) {
    snapshots.emplace(options.snapshots_folder, film, session.scene().settings);
    if (!snapshots->error().empty()) return fail(snapshots->error());
    observers.push_back(&*snapshots);
  }
  Audience audience(std::move(observers));
  priority::TraceOptions tracing = trace_options(options, session);
  tracing.steering = &steering;
  tracing.observer = &audience;
  const bool keys = !options.quiet && options.steer != "-" && line.is_shown() && RawTerminal::exists();
  if (keys) controls.push_back(std::make_unique<TerminalKeys>(line));
  priority::TraceResult traced;
  {
    const Cockpit cockpit(steering, desk, std::move(controls));
    traced = session.trace(film, tracing);
    desk.serve();  // who asked in the last moment
  }
  line.clear();
  if (!traced.error.empty()) return fail(traced.error);
  if (stop && !traced.complete()) return interrupted_since(start);
  Stats stats = stats_of(options, session, tracing, traced, start);

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
