#pragma once
#include "tests/golden/run.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace firstlight::golden {

inline constexpr std::chrono::seconds kRenderLimit{120};

/// Renders `scene` at 160x120 into `picture` with `program`, which may be POV-Ray: both are given the same options.
/// The program runs in the folder of the scene, where POV-Ray looks for what the scene includes and may read.
/// `home` is a folder for its use. `more` is added to the options.
ProcessResult render(const std::string& program, const std::filesystem::path& scene,
                     const std::filesystem::path& picture, const std::filesystem::path& home,
                     const std::vector<std::string>& more = {});

}  // namespace firstlight::golden
