#include "app/long_options.h"

#include "app/memory_size.h"
#include "app/pov_switches.h"
#include "priority/driver.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace firstlight::app {
namespace {

double positive(const std::string& text) {
  const auto value = parse<double>(text);
  if (!value || !std::isfinite(*value) || *value <= 0.0) {
    throw CLI::ValidationError(fmt::format("expected a number greater than 0, found '{}'", text));
  }
  return *value;
}

int threads(const std::string& text) {
  const auto count = parse<int>(text);
  if (!count || *count < 1 || *count > kMostThreads) {
    throw CLI::ValidationError(fmt::format("expected a number from 1 to {}, found '{}'", kMostThreads, text));
  }
  return *count;
}

std::size_t queue_memory(const std::string& text) {
  const auto bytes = parse_memory_size(text);
  if (!bytes) throw CLI::ValidationError(fmt::format("expected a size such as 500k, 16M or 1.5G, found '{}'", text));
  if (*bytes < priority::kSmallestQueueMemory) {
    throw CLI::ValidationError(fmt::format("{} are too little for the queue; it needs at least {}",
                                           short_memory_size(*bytes),
                                           short_memory_size(priority::kSmallestQueueMemory)));
  }
  return *bytes;
}

}  // namespace

LongOptions::LongOptions(CommandLine& out)
    : out_(out),
      app_(std::make_unique<CLI::App>("Renders a POV-Ray scene, the rays that matter most first.", "firstlight")) {
  Options& options = out.options;
  const auto text = [&](const char* name, std::string& target, const char* meaning, const char* type) {
    app_->add_option(name, target, meaning)->type_name(type)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  };
  const auto read = [&](const char* name, auto reader, const char* meaning, const char* type) {
    app_->add_option_function<std::string>(name, reader, meaning)->type_name(type);
  };
  app_->set_help_flag("--help", "Show this help and leave");
  app_->add_flag_callback(
      "--version", [&out] { out.wish = CommandLine::Wish::version; }, "Show the version and leave");
  read(
      "--threads", [&](const std::string& count) { options.threads = threads(count); },
      "Threads that trace; all processors if not given", "N");
  text("--scheme", options.scheme, "The order of the rays (see below)", "TEXT");
  read(
      "--boost", [&](const std::string& boost) { options.boosts.push_back(boost); },
      "Some rays before all others (see below); may be repeated", "TEXT");
  read(
      "--queue-memory", [&](const std::string& size) { options.queue_memory = queue_memory(size); },
      "Most bytes for waiting rays, such as 16M or 1G; a quarter of the memory if not given", "SIZE");
  read(
      "--stop-at-error", [&](const std::string& error) { options.stop_at_error = positive(error); },
      "Stop when the picture is at most so far off, on the average over the pixels; white is 1", "E");
  read(
      "--stop-after", [&](const std::string& seconds) { options.stop_after = positive(seconds); },
      "Stop after so many seconds of tracing", "SECONDS");
  text("--steer", options.steer, "Make a socket to steer from, see `firstlight steer`; -: standard input", "SOCKET");
  text("--stats", options.stats_file, "Write times, rays and queue sizes as JSON", "FILE");
  text("--snapshots", options.snapshots_folder, "Write intermediate pictures to a folder", "DIR");
  read(
      "--permissions", [&](const std::string& file) { options.permission_files.push_back(file); },
      "What the scene may read and write, in the syntax of povray.conf; may be repeated, all must permit", "FILE");
  text("--front-end", options.front_end, "Read the scene with a loadable module", "FILE");
  app_->add_flag("--quiet", options.quiet, "Show errors only");
  app_->add_flag("--parse-only", options.parse_only,
                 "Read the scene, say what is in it and what cannot be rendered, and leave");
  app_->add_flag("--json", options.json, "With --parse-only: say it as JSON");
}

LongOptions::~LongOptions() = default;

const CLI::Option* LongOptions::find(const std::string& name) const { return app_->get_option_no_throw(name); }

bool LongOptions::takes_value(const std::string& name) const { return find(name)->get_items_expected_min() > 0; }

void LongOptions::read_word(const std::string& word) {
  try {
    app_->parse(std::vector<std::string>{word});
  } catch (const CLI::CallForHelp&) {
    out_.wish = CommandLine::Wish::help;
  } catch (const CLI::ValidationError& error) {
    // The message of our own readers says what is wrong with the value; that of CLI11's checks names the option too.
    const std::string what = error.what();
    const std::string name = word.substr(0, word.find('='));
    out_.errors.push_back(what.starts_with(name) ? what : fmt::format("{}: {}", name, what));
  } catch (const CLI::ParseError& error) {
    out_.errors.emplace_back(error.what());
  }
}

std::string LongOptions::help() const {
  std::string text;
  for (const CLI::Option* option : app_->get_options()) {
    const std::string left =
        option->get_name() + (option->get_items_expected_min() > 0 ? " " + option->get_type_name() : "");
    text += fmt::format("  {:<25}  {}\n", left, option->get_description());
  }
  return text;
}

std::vector<std::string> LongOptions::names() const {
  std::vector<std::string> names;
  for (const CLI::Option* option : app_->get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string option_of_setting(std::string_view setting) {
  std::string name = lower(setting);
  std::ranges::replace(name, '_', '-');
  return "--" + name;
}

std::string setting_of_option(std::string_view option) {
  std::string name(option.substr(2));
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace firstlight::app
