#pragma once
#include "tests/golden/run.h"

#include <filesystem>
#include <string>
#include <vector>

namespace firstlight::golden {

/// Runs the program on `scene`, which it must refuse: exit code 1 in good time, no signal, a message with "error: " on
/// standard error and no picture, not even a part of one. Gives the test's failures itself, and returns the run.
ProcessResult expect_refusal(const std::filesystem::path& scene, const ScratchFolder& scratch,
                             const std::vector<std::string>& more = {});

/// The same for a whole command line, which names its output `picture`.
ProcessResult expect_command_refused(const std::vector<std::string>& options, const std::filesystem::path& picture,
                                     const ScratchFolder& scratch);

/// Every line of `text`.
std::vector<std::string> lines_of(const std::string& text);

}  // namespace firstlight::golden
