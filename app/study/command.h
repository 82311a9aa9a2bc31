#pragma once

#include <atomic>
#include <span>
#include <string>

namespace firstlight::app {

/// `firstlight study ...`: `arguments` stand behind that word. `stop` becomes true when the user wants an end. Returns
/// the exit code.
int study_command(std::span<const std::string> arguments, const std::atomic<bool>& stop);

}  // namespace firstlight::app
