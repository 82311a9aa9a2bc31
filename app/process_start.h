#pragma once

#include <chrono>

namespace firstlight::app {

/// When the system began this process: before the loader bound its libraries, which takes longer than a small scene.
/// To a hundredth of a second, never in the future; the time of the call where the system does not tell.
std::chrono::steady_clock::time_point process_start();

}  // namespace firstlight::app
