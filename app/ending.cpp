#include "app/ending.h"

#include "app/progress.h"

#include <fmt/format.h>

namespace firstlight::app {
namespace {

/// Empty for a finished picture.
std::string reason(const Options& options, priority::End end) {
  switch (end) {
    case priority::End::stopped:
      return "stopped by the user";
    case priority::End::error_reached:
      return fmt::format("stopped at an error of {} or less", options.stop_at_error);
    case priority::End::time_over:
      return fmt::format("stopped after {} s", options.stop_after);
    case priority::End::complete:
    case priority::End::failed:
      break;
  }
  return {};
}

}  // namespace

std::string end_name(priority::End end) {
  switch (end) {
    case priority::End::complete:
      return "complete";
    case priority::End::stopped:
      return "stopped";
    case priority::End::error_reached:
      return "error-reached";
    case priority::End::time_over:
      return "time-over";
    case priority::End::failed:
      return "failed";
  }
  return {};
}

std::string summary(const Options& options, const std::string& picture, const Stats& stats) {
  std::string text = options.write_picture ? picture : "no picture written";
  text += fmt::format(": {} x {}", stats.width, stats.height);
  if (const std::string why = reason(options, stats.end); !why.empty()) {
    text += fmt::format(", not finished: {}, {};", why,
                        remaining_text(stats.rays.remaining, stats.rays.remaining_is_bound));
  } else {
    text += ",";
  }
  text += fmt::format(" {} rays, trace {}, total {}", short_count(stats.rays.rays.total()), short_time(stats.trace),
                      short_time(stats.total));
  if (stats.preview) text += fmt::format(", preview after {}", short_time(*stats.preview));
  if (stats.first_image) text += fmt::format(", first image after {}", short_time(*stats.first_image));
  return text;
}

}  // namespace firstlight::app
