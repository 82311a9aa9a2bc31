#pragma once

#include "app/options.h"
#include "app/stats.h"

#include <string>

namespace firstlight::app {

/// Why tracing ended, in one word: "complete", "stopped", "error-reached", "time-over", "failed".
std::string end_name(priority::End end);

/// Tells the user at the end where the picture is, how far it came and what ended it, rays and times.
std::string summary(const Options& options, const std::string& picture, const Stats& stats);

}  // namespace firstlight::app
