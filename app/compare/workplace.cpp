#include "app/compare/workplace.h"

#include "app/compare/content.h"
#include "app/pov_switches.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

/// Whether POV-Ray's usual restrictions let a program that runs elsewhere read what is in the folder.
bool may_be_read_from_elsewhere(const fs::path& folder) {
  const char* const home = std::getenv("HOME");
  std::error_code ignored;
  const fs::path place = fs::weakly_canonical(folder, ignored);
  for (const fs::path& allowed : {fs::path(home != nullptr ? home : ""), fs::path("/tmp"),
                                  fs::path("/usr/share/doc/povray/examples"), fs::path("/etc/povray")}) {
    if (allowed.empty() || allowed == "/") continue;
    const fs::path top = fs::weakly_canonical(allowed, ignored);
    if (std::mismatch(top.begin(), top.end(), place.begin(), place.end()).first == top.end()) return true;
  }
  return false;
}

}  // namespace

Workplace::Workplace(const SceneJob& job) : scene_(job.scene), scene_folder_(job.scene.parent_path()) {
  if (!SceneContent({}).writes_files(scene_)) return;
  scratch_.emplace();
  if (!may_be_read_from_elsewhere(scene_folder_)) home_ = scene_folder_;
}

std::vector<fs::path> Workplace::libraries() const {
  if (!scratch_) return {};
  return {scene_folder_};
}

std::string Workplace::placed(const std::string& word) const {
  if (!scratch_) return word;
  for (const std::string_view name : {"+l", "-l", "library_path="}) {
    if (word.size() <= name.size() || !lower(word).starts_with(name) || word[name.size()] == '/') continue;
    return word.substr(0, name.size()) + (scene_folder_ / word.substr(name.size())).string();
  }
  return word;
}

}  // namespace firstlight::app::compare
