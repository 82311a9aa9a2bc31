#include "render/image/link_target.h"

#include <system_error>

namespace firstlight::render {

namespace fs = std::filesystem;

fs::path link_target(const fs::path& path) {
  constexpr int kMostLinks = 40;  // as Linux follows
  std::error_code error;
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    if (links == kMostLinks) return path;
    // An absolute link replaces all of it.
    target = target.parent_path() / fs::read_symlink(target, error);
    if (error) return path;
  }
  return target;
}

}  // namespace firstlight::render
