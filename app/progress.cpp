#include "app/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace firstlight::app {
namespace {

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : 80;
}

}  // namespace

std::string short_count(std::uint64_t count) {
  const auto value = static_cast<double>(count);
  if (count < 10'000) return fmt::format("{}", count);
  if (count < 1'000'000) return fmt::format("{:.0f} k", value / 1e3);
  if (count < 1'000'000'000) return fmt::format("{:.1f} M", value / 1e6);
  return fmt::format("{:.2f} G", value / 1e9);
}

std::string short_time(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.2f} s", seconds);
  const auto whole = static_cast<long>(seconds);
  return whole < 6000 ? fmt::format("{}:{:02} min", whole / 60, whole % 60)
                      : fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

ProgressLine::ProgressLine(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::stage(const std::string& what) { show(what); }

void ProgressLine::progress(const priority::Progress& progress) {
  if (!shown_) return;
  // The first image is worth a third of the bar; then it is the share of the known rays that are traced.
  constexpr double kFirstImageShare = 0.33;
  double done = kFirstImageShare * progress.tiles_done / std::max(progress.tiles, 1u);
  if (progress.rays_waiting == 0) {
    done = static_cast<double>(progress.tiles_done) / std::max(progress.tiles, 1u);
  } else if (progress.tiles_done == progress.tiles) {
    done += (1.0 - kFirstImageShare) * static_cast<double>(progress.rays_traced) /
            static_cast<double>(progress.rays_traced + progress.rays_waiting);
  }
  percent_ = std::max(percent_, 100.0 * done);
  const double rate = progress.seconds > 0.0 ? static_cast<double>(progress.rays_traced) / progress.seconds : 0.0;
  show(fmt::format("{} {:3.0f} %  {} rays done, {} waiting, {} a second, {}",
                   progress.tiles_done < progress.tiles ? "first image" : "refining", percent_,
                   short_count(progress.rays_traced), short_count(progress.rays_waiting),
                   short_count(static_cast<std::uint64_t>(rate)), short_time(progress.seconds)));
}

void ProgressLine::clear() {
  if (!std::exchange(on_screen_, false)) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

void ProgressLine::show(std::string text) {
  if (!shown_) return;
  text.resize(std::min(text.size(), terminal_width() - 1));
  fmt::print(stderr, "\r{}\x1b[K", text);
  std::fflush(stderr);
  on_screen_ = true;
}

}  // namespace firstlight::app
