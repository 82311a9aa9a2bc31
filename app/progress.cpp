#include "app/progress.h"

#include "app/output.h"
#include "render/scene/escaped.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
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

std::string remaining_text(double remaining, bool is_bound) {
  return fmt::format(
      "{} {} off", is_bound ? "at most" : "about",
      remaining < 0.0001 && remaining > 0.0 ? fmt::format("{:.1e}", remaining) : fmt::format("{:.4f}", remaining));
}

double percent_done(const priority::Progress& progress) {
  // The first image is worth a third of the whole; then it is the share of the known rays that are traced.
  constexpr double kFirstImageShare = 0.33;
  const double first_image = static_cast<double>(progress.tiles_done) / std::max(progress.tiles, 1u);
  if (progress.rays_waiting == 0) return 100.0 * first_image;
  double done = kFirstImageShare * first_image;
  if (progress.tiles_done == progress.tiles) {
    const auto traced = static_cast<double>(progress.traced.total());
    done += (1.0 - kFirstImageShare) * traced / (traced + static_cast<double>(progress.rays_waiting));
  }
  return 100.0 * done;
}

std::string progress_text(const priority::Progress& progress, double percent, bool paused) {
  const double rate = progress.seconds > 0.0 ? static_cast<double>(progress.traced.total()) / progress.seconds : 0.0;
  const char* const stage = progress.tiles_done < progress.tiles ? "first image" : "refining";
  return fmt::format("{} {:.0f} %, {}, {} rays done, {} waiting, {} a second, {}", paused ? "paused at" : stage,
                     percent, remaining_text(progress.remaining, progress.remaining_is_bound),
                     short_count(progress.traced.total()), short_count(progress.rays_waiting),
                     short_count(static_cast<std::uint64_t>(rate)), short_time(progress.seconds));
}

ProgressLine::ProgressLine(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::stage(const std::string& what) {
  const std::lock_guard lock(mutex_);
  show(what);
}

void ProgressLine::set_hint(std::string hint) {
  const std::lock_guard lock(mutex_);
  hint_ = std::move(hint);
}

void ProgressLine::progress(const priority::Progress& progress, bool paused) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  percent_ = std::max(percent_, percent_done(progress));
  show(progress_text(progress, percent_, paused));
}

void ProgressLine::note(const std::string& text) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  wipe();
  say(text.ends_with('\n') ? text.substr(0, text.size() - 1) : text);
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  wipe();
}

void ProgressLine::wipe() {
  if (!std::exchange(on_screen_, false)) return;
  draw("\r\x1b[K");
}

void ProgressLine::show(std::string text) {
  if (!shown_) return;
  text = render::escaped(text);
  const std::size_t hint = hint_.empty() ? 0 : hint_.size() + 2;
  const std::size_t width = std::max(terminal_width() - 1, hint);
  text.resize(std::min(text.size(), width - hint));
  if (hint > 0) text += "  " + hint_;
  draw(fmt::format("\r{}\x1b[K", text));
  on_screen_ = true;
}

}  // namespace firstlight::app
