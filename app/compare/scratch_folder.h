#pragma once

#include <filesystem>
#include <string>

namespace firstlight::app::compare {

/// A folder of its own under /tmp (where POV-Ray's file restrictions allow to write), removed at the end with all in it.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Empty, or why there is none.
  const std::string& error() const { return error_; }
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
  std::string error_;
};

}  // namespace firstlight::app::compare
