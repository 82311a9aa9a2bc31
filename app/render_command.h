#pragma once

#include "app/options.h"

#include <atomic>
#include <chrono>

namespace firstlight::app {

/// Renders what the options ask for and says on the error stream how it went. `start`: of the process. `stop` becomes
/// true when the user wants an end. Returns the exit code.
int render_command(const Options& options, std::chrono::steady_clock::time_point start, const std::atomic<bool>& stop);

}  // namespace firstlight::app
