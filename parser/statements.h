#pragma once

#include "parser/reader.h"
#include "parser/value.h"
#include "render/scene/scene_builder.h"
#include "render/texture/density_grid.h"
#include "render/texture/image_store.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace firstlight::parser {

/// What a scene has said about radiosity, for what is checked when all is said.
struct RadiosityText {
  Token word;  ///< of the last block
  bool minimum_reuse = false, maximum_reuse = false;
};

/// What statements need beside the text: the scene under construction and the defaults that `#default` sets.
struct SceneContext {
  explicit SceneContext(render::SceneBuilder& scene_builder) : builder(scene_builder) {}

  render::SceneBuilder& builder;
  /// One layer; `#default` replaces it. Never null; shared by all objects that use it.
  render::TexturePtr default_texture =
      std::make_shared<const render::Texture>(render::Texture{std::vector<render::TextureLayer>(1)});
  bool default_given = false;                  ///< there was a `#default`
  render::Shared<render::Finish> last_finish;  ///< see kept_once()
  render::Camera default_camera;
  render::Camera camera;  ///< the scene's so far; before version 3.5 a further camera statement goes on from it
  RadiosityText radiosity;
  render::ImageStore images;
  std::map<std::string, std::shared_ptr<const render::DensityGrid>> density_files;  ///< by path
  std::uint64_t size = 0;  ///< objects in the scene so far, with all that they are made of
};

// One function per statement kind, each called with the keyword taken already and the `{` next; each leaves the
// reader behind the `}`. Files parse_shape, parse_object, parse_texture, parse_light, parse_camera, parse_settings.

/// Whole scene: every statement up to the end of the text. [parse_scene.cpp]
void parse_scene(Reader& reader, SceneContext& context);
/// One value to be declared, as after `#declare Name =`, an array element or a macro argument: object, texture,
/// pigment, finish, interior, material, color_map, camera, light_source, transform. Empty when the next token begins
/// none of these, nothing taken then; numbers and strings are the caller's. [parse_declared.cpp]
std::optional<Value> parse_declarable(Reader& reader, SceneContext& context);
/// `#default { texture | pigment | finish | camera }`; also for the old `default {` [parse_declared.cpp]
void parse_default(Reader& reader, SceneContext& context);

/// Object expression of any kind (sphere, union, object { Name }, a declared object ...); empty when the next token
/// begins none. [parse_object.cpp]
std::optional<render::Object> parse_object(Reader& reader, SceneContext& context);

}  // namespace firstlight::parser
