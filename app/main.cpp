#include "app/compare/command.h"
#include "app/exit_code.h"
#include "app/heap.h"
#include "app/options.h"
#include "app/output.h"
#include "app/parse_command.h"
#include "app/process_start.h"
#include "app/raw_terminal.h"
#include "app/render_command.h"
#include "app/steer_client.h"
#include "app/study/command.h"
#include "app/version.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <vector>

namespace {

std::atomic<bool> g_stop = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

std::atomic<double> g_stop_time = 0.0;  // seconds, of the first request
static_assert(std::atomic<double>::is_always_lock_free, "a signal handler sets it");

// The second Ctrl-C does what Ctrl-C always does: it ends the program at once. But `timeout` and others send a signal
// to the program and to its group at the same moment, which is one request.
void ask_to_stop(int signal) {
  constexpr double kOneRequest = 0.5;
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const double seconds = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  if (!g_stop.exchange(true)) g_stop_time = seconds;
  if (seconds - g_stop_time < kOneRequest) return;
  firstlight::app::RawTerminal::restore();
  std::signal(signal, SIG_DFL);
  raise(signal);
}

// A file that has grown too large by our own writing is an error of that writing.
void ask_to_stop_from_outside(int signal, siginfo_t* sent, void*) {
  if (sent->si_pid != getpid()) ask_to_stop(signal);
}

void watch_signals() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A terminal that goes away, unless the user does not care, as with `nohup`.
  struct sigaction former {};
  sigaction(SIGHUP, nullptr, &former);
  if (former.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  action.sa_sigaction = ask_to_stop_from_outside;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGXFSZ, &action, nullptr);
}

int run(std::vector<std::string> arguments, std::chrono::steady_clock::time_point start) {
  using firstlight::app::CommandLine;
  if (!arguments.empty() && arguments[0] == "steer") {
    return firstlight::app::steer_client(std::span(arguments).subspan(1));
  }
  if (!arguments.empty() && arguments[0] == "study") {
    watch_signals();
    return firstlight::app::study_command(std::span(arguments).subspan(1), g_stop);
  }
  if (!arguments.empty() && arguments[0] == "compare") {
    watch_signals();
    return firstlight::app::compare::compare_command(std::span(arguments).subspan(1), g_stop);
  }
  const CommandLine line = firstlight::app::parse_command_line(arguments);
  switch (line.wish) {
    case CommandLine::Wish::help:
      return firstlight::app::print(firstlight::app::help_text());
    case CommandLine::Wish::version:
      return firstlight::app::print(fmt::format("firstlight {}\n", firstlight::app::kVersion));
    case CommandLine::Wish::render:
      break;
  }
  for (const std::string& warning : line.warnings) {
    if (!line.options.quiet) firstlight::app::say_warning(warning);
  }
  for (const std::string& error : line.errors) firstlight::app::say_error(error);
  if (!line.errors.empty()) return firstlight::app::kExitFailure;
  watch_signals();
  if (line.options.parse_only) return firstlight::app::parse_command(line.options, g_stop);
  return firstlight::app::render_command(line.options, start, g_stop);
}

}  // namespace

int main(int argc, char** argv) {
  const auto start = firstlight::app::process_start();
  firstlight::app::keep_freed_memory();
  firstlight::app::secure_standard_streams();
  try {
    return run({argv + 1, argv + argc}, start);
  } catch (const std::bad_alloc&) {
    firstlight::app::say_error("not enough memory");
  } catch (const std::exception& exception) {
    firstlight::app::say_error(exception.what());
  }
  return firstlight::app::kExitFailure;
}
