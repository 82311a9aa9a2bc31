#pragma once

#include "app/compare/settings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app::compare {

/// A scene of a list or folder, with what is to be known of it before it is rendered.
struct ListedScene {
  std::string name;             ///< its path below the root without `.pov`, with its words behind it if it has some
  std::filesystem::path scene;  ///< absolute
  std::optional<std::filesystem::path> ini;  ///< as SceneJob::ini
  std::vector<std::string> words;            ///< switches for both programs, of this scene alone
  std::optional<double> share;               ///< thresholds of its own, as in Thresholds
  std::optional<double> psnr;
};

struct SceneList {
  std::vector<ListedScene> scenes;
  std::vector<std::string> errors;  ///< when not empty, nothing else counts
};

/// Every `.pov` file below `folder`, by name.
SceneList find_scenes(const std::filesystem::path& folder);

/// The scenes that a file names, one a line: its path below `root` (with or without `.pov`), then perhaps an .ini file
/// in the scene's folder and switches, with quotes around what holds blanks. `#` and `;` begin a comment. Errors are
/// told as file:line.
SceneList read_list(const std::filesystem::path& file, const std::filesystem::path& root);
/// The same of the text of a file that is called `label`.
SceneList parse_list(std::string_view text, const std::string& label, const std::filesystem::path& root);

/// Reads a scene's wishes for its comparison from comments of its text: `// compare: share 99.9`,
/// `// compare: psnr 35`, `// compare: ini quick.ini[High]`. Wishes of the list go before.
void read_wishes(std::string_view scene_text, ListedScene& scene);

}  // namespace firstlight::app::compare
