#pragma once

#include "app/compare/record.h"

#include <atomic>
#include <span>
#include <string>

namespace firstlight::app::compare {

constexpr int kExitUnreadable = 4;

/// Says why there is nothing to be judged. Returns kExitUnreadable.
int fail(const std::string& why);

/// As `idiff` has it: 0 agrees, 1 warns, 2 differs, 3 other size, 4 when there are not two pictures.
int exit_code(Status status);

/// `firstlight compare`, with the arguments behind that word. `stop` becomes true when the user wants an end. Returns the
/// exit code.
int compare_command(std::span<const std::string> arguments, const std::atomic<bool>& stop);

}  // namespace firstlight::app::compare
