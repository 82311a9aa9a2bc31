#pragma once

#include <filesystem>

namespace firstlight::render {

/// Finds the file to be written so that a link stays a link: the one that `path` leads to over symbolic links, though
/// it may not exist yet; `path` itself when it is none, or when its links lead in a circle.
std::filesystem::path link_target(const std::filesystem::path& path);

}  // namespace firstlight::render
