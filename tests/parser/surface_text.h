#pragma once

#include "tests/parser/scene_text.h"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace firstlight::parser {

/// Loads `text`, and takes nothing that cannot be rendered for an error; otherwise as load().
inline render::LoadResult load_described(std::string_view text) {
  const SceneFile file("#version 3.7; global_settings { assumed_gamma 1 } " + std::string(text) +
                       "\ncamera { location <0, 0, -5> look_at 0 }\n");
  render::LoadOptions options;
  options.parse_only = true;
  return PovFrontEnd().load(file.path(), options);
}

/// The scene of `text`, which must have neither errors nor warnings.
inline std::unique_ptr<const render::Scene> surface_scene(std::string_view text) {
  render::LoadResult result = load_described(text);
  EXPECT_EQ(errors(result), "") << text;
  EXPECT_EQ(warnings(result), "") << text;
  if (!result.scene) return std::make_unique<const render::Scene>();
  return std::move(result.scene);
}

/// The words for what `text` asks for and cannot be rendered, in order, each with a space behind it.
inline std::string unrendered(std::string_view text) {
  const render::LoadResult result = load_described(text);
  EXPECT_EQ(errors(result), "") << text;
  std::string words;
  for (const render::Diagnostic& use : result.summary.unrendered) words += use.subject + " ";
  return words;
}

inline const render::TextureLayer& layer_of(const render::Scene& scene, std::size_t part = 0, std::size_t layer = 0) {
  return scene.textures.at(scene.parts.at(part).texture).texture->layers[layer];
}
inline const render::Interior& interior_of(const render::Scene& scene, std::size_t part = 0) {
  return scene.interiors.at(scene.parts.at(part).interior);
}

/// The pigment, normal or texture pattern that the words in its braces describe.
inline render::Pigment pigment_of(std::string_view words) {
  return layer_of(*surface_scene("sphere { 0, 1 pigment { " + std::string(words) + " } }")).pigment;
}
inline render::Normal normal_of(std::string_view words) {
  const auto normal = layer_of(*surface_scene("sphere { 0, 1 normal { " + std::string(words) + " } }")).extras->normal;
  return normal ? *normal : render::Normal();
}
inline render::TexturePattern texture_pattern_of(std::string_view words) {
  const auto pattern =
      layer_of(*surface_scene("sphere { 0, 1 texture { " + std::string(words) + " } }")).extras->patterned;
  return pattern ? *pattern : render::TexturePattern();
}
/// The message about those words in a pigment.
inline std::string pigment_error(std::string_view words) {
  return errors(load_described("sphere { 0, 1 pigment { " + std::string(words) + " } }"));
}

template <class T>
const T& parameters(const render::Patterning& pattern) {
  static const T none{};
  const T* found = std::get_if<T>(&pattern.parameters);
  EXPECT_NE(found, nullptr) << spelling(pattern.kind);
  return found ? *found : none;
}

/// Whether `text` has the words in it.
inline bool says(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

}  // namespace firstlight::parser
