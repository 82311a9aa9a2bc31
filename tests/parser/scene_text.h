#pragma once

#include "parser/parser.h"
#include "render/scene/front_end.h"
#include "render/texture/pigment.h"
#include "render/surface/compiled_pigment.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace firstlight::parser {

/// A file with `text` that goes when the object does.
class SceneFile {
 public:
  explicit SceneFile(std::string_view text) {
    static std::atomic<int> count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("firstlight_scene_" + std::to_string(getpid()) + "_" + std::to_string(count++) + ".pov");
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~SceneFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// Loads `text` as it stands.
inline render::LoadResult load_bare(std::string_view text) {
  const SceneFile file(text);
  return PovFrontEnd().load(file.path(), render::LoadOptions());
}

/// The same in version 3.7, with a camera behind the text. Lines and columns are those of `text`.
inline render::LoadResult load(std::string_view text) {
  return load_bare("#version 3.7; global_settings { assumed_gamma 1 } " + std::string(text) +
                   "\ncamera { location <0, 0, -5> look_at 0 }\n");
}

inline std::string messages(const render::LoadResult& result, render::Diagnostic::Severity severity) {
  std::string all;
  for (const auto& diagnostic : result.diagnostics) {
    if (diagnostic.severity == severity) all += diagnostic.message + "\n";
  }
  return all;
}
inline std::string errors(const render::LoadResult& result) {
  return messages(result, render::Diagnostic::Severity::error);
}
inline std::string warnings(const render::LoadResult& result) {
  return messages(result, render::Diagnostic::Severity::warning);
}

/// The scene of `text`, which must have neither errors nor warnings.
inline std::unique_ptr<const render::Scene> scene_of(std::string_view text) {
  render::LoadResult result = load(text);
  EXPECT_EQ(errors(result), "") << text;
  EXPECT_EQ(warnings(result), "") << text;
  if (!result.scene) return std::make_unique<const render::Scene>();
  return std::move(result.scene);
}

/// The finish of the top layer of a part.
inline const render::Finish& finish_of(const render::Scene& scene, std::size_t part = 0) {
  return scene.textures.at(scene.parts.at(part).texture).texture->layers.front().finish;
}

/// The pigment colour of a part's layer at a point of the world.
inline render::FilteredColor color_of(const render::Scene& scene, const render::Vec3& point, std::size_t part = 0,
                                      std::size_t layer = 0) {
  const render::PlacedTexture& placed = scene.textures.at(scene.parts.at(part).texture);
  return render::CompiledPigment(placed.texture->layers[layer].pigment, render::PatternWorld())
      .color_at(placed.to_texture.point(point));
}

inline bool inside(const render::Scene& scene, const render::Vec3& point, std::size_t solid = 0) {
  return scene.solids.at(solid).inside(point);
}

inline void expect_near(const render::Vec3& a, const render::Vec3& b, double tolerance = 1e-12) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace firstlight::parser
