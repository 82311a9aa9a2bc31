#pragma once

#include "parser/reader.h"
#include "parser/value.h"
#include "render/scene/scene_builder.h"

#include <optional>

namespace firstlight::parser {

/// What statements need beside the text: the scene under construction and the defaults that `#default` sets.
struct SceneContext {
  render::SceneBuilder& builder;
  render::Texture default_texture;  ///< one layer; pigment and finish can be replaced by #default
  render::Camera default_camera;
};

// One function per statement kind, each called with the keyword taken already and the `{` next; each leaves the
// reader behind the `}`. Files parse_shape, parse_object, parse_texture, parse_light, parse_camera, parse_settings.

/// Whole scene: every statement up to the end of the text. [parse_scene.cpp]
void parse_scene(Reader& reader, SceneContext& context);
/// One value to be declared, as after `#declare Name =`, an array element or a macro argument: object, texture, pigment, finish,
/// interior, material, color_map, camera, light_source, transform. Empty when the next token begins none of these, nothing taken then;
/// numbers and strings are the caller's. [parse_declared.cpp]
std::optional<Value> parse_declarable(Reader& reader, SceneContext& context);
/// `#default { texture | pigment | finish | camera }`; also for the old `default {` [parse_declared.cpp]
void parse_default(Reader& reader, SceneContext& context);

/// Object expression of any kind (sphere, union, object { Name }, a declared object ...); empty when the next token begins none. [parse_object.cpp]
std::optional<render::Object> parse_object(Reader& reader, SceneContext& context);

}  // namespace firstlight::parser
