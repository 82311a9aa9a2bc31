#pragma once

#include "app/compare/scratch_folder.h"
#include "app/compare/settings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace firstlight::app::compare {

/// Where a program runs on a scene: in the scene's folder, where POV-Ray looks for what the scene includes and may read.
/// But what a scene writes would stay there, and be met by the other program. So a scene that writes files is
/// rendered in an empty folder that is removed afterwards, and its own folder is the first one to be searched.
class Workplace {
 public:
  explicit Workplace(const SceneJob& job);

  /// Empty, or why there is none.
  std::string error() const { return scratch_ ? scratch_->error() : ""; }
  const std::filesystem::path& folder() const { return scratch_ ? scratch_->path() : scene_folder_; }
  /// The program's HOME, below which POV-Ray may read; empty: ours.
  const std::filesystem::path& home() const { return home_; }
  /// The scene as it is called from the folder.
  std::filesystem::path scene() const { return scratch_ ? scene_ : scene_.filename(); }
  /// To be searched before all others.
  std::vector<std::filesystem::path> libraries() const;
  /// A word of the user, whose relative paths are meant from the scene's folder.
  std::string placed(const std::string& word) const;

 private:
  std::filesystem::path scene_;
  std::filesystem::path scene_folder_;
  std::filesystem::path home_;
  std::optional<ScratchFolder> scratch_;
};

}  // namespace firstlight::app::compare
