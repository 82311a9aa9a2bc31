#pragma once

#include <filesystem>

namespace firstlight::parser {

/// Marks a file that this program has made, and the time of its last change: in an extended attribute, for scenes write
/// again in a later run what they wrote in an earlier one. Does nothing where the file system keeps no attributes.
/// Pre: `descriptor` is open for writing, and nothing is written after.
void mark_own_work(int descriptor);
/// Whether the file bears that mark and has not been changed since.
bool is_own_work(const std::filesystem::path& path);

}  // namespace firstlight::parser
