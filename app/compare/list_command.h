#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>

namespace firstlight::app::compare {

/// `firstlight compare FOLDER`, `--list FILE`, several scenes, or one of which a report is wanted: `arguments` stand
/// behind the word `compare`. The exit code, or nothing when it is not for many scenes. `stop` becomes true when the
/// user wants an end.
std::optional<int> compare_list_command(std::span<const std::string> arguments, const std::atomic<bool>& stop);

/// A part of the help, of the options that only this has.
std::string list_help_text();

}  // namespace firstlight::app::compare
