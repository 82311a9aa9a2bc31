#pragma once

#include "render/scene/bounding_rules.h"
#include "render/scene/diagnostic.h"
#include "render/scene/quality.h"
#include "render/scene/scene.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace firstlight::render {

/// How far the reading of a scene has come.
struct ParseProgress {
  std::string file;  ///< that is being read
  std::size_t line = 0;
  std::uint64_t tokens = 0;   ///< of the scene language, so far
  std::uint64_t objects = 0;  ///< with their parts
};

/// A front end needs these beside the path.
struct LoadOptions {
  int width = 320;  ///< pixels; scenes may read it
  int height = 240;
  std::vector<std::string> library_paths;  ///< searched for included files after the scene's own folder
  std::vector<std::pair<std::string, std::string>>
      declares;  ///< identifiers set before the scene is read (name, number)
  /// Files in the syntax of povray.conf, each of which must permit what a scene reads and writes. None: what a plain
  /// installation permits.
  std::vector<std::string> permission_files;
  std::size_t value_memory = std::size_t{1} << 31;  ///< bytes that the scene's strings and arrays may take up
  double clock = 0.0;
  BoundingRules bounding;
  Quality quality;
  bool parse_only = false;  ///< what cannot be rendered is listed in the summary, not refused
  /// Called for every diagnostic as it arises; may be empty. The result holds them all the same.
  std::function<void(const Diagnostic&)> report;
  /// Called a few times a second once reading takes longer than one; may be empty.
  std::function<void(const ParseProgress&)> progress;
  /// When it becomes true, reading ends soon, with an error that says so. May be null.
  const std::atomic<bool>* stop = nullptr;
};

/// Counts of what a scene is made of.
struct SceneSummary {
  std::size_t objects = 0;  ///< at top level; unions count as their members
  std::size_t lights = 0;
  std::size_t textures = 0;                       ///< as used: the same texture in two places counts twice
  std::map<std::string, std::uint64_t> keywords;  ///< reserved words, and how often each was read
  Diagnostics unrendered;  ///< features that cannot be rendered, each where it is first asked for
};

/// `scene` is null exactly when the diagnostics hold an error.
struct LoadResult {
  std::unique_ptr<const Scene> scene;
  Diagnostics diagnostics;
  SceneSummary summary;
};

/// A scene language as the renderer sees it. Implementations never throw, exit or print.
class FrontEnd {
 public:
  virtual ~FrontEnd() = default;
  virtual std::string_view name() const = 0;                     ///< e.g. "pov"
  virtual std::vector<std::string_view> extensions() const = 0;  ///< with the dot: ".pov"
  virtual LoadResult load(const std::string& path, const LoadOptions& options) const = 0;
};

/// A loadable module exports these two C symbols; the host refuses a module of another ABI version.
constexpr int kFrontEndAbi = 5;
constexpr const char* kFrontEndAbiSymbol = "firstlight_front_end_abi";  ///< int firstlight_front_end_abi()
constexpr const char* kFrontEndSymbol =
    "firstlight_front_end";  ///< const FrontEnd* firstlight_front_end(); lives as long as the module

}  // namespace firstlight::render
