#pragma once

#include "parser/directive/reader.h"
#include "parser/directive/scene_context.h"
#include "render/scene/object.h"

#include <optional>

namespace firstlight::parser {

// One function per statement kind, each called with the keyword taken already and the `{` next; each leaves the
// reader behind the `}`. Files parse_shape, parse_object, parse_texture, parse_light, parse_camera, parse_settings.

/// Whole scene: every statement up to the end of the text. [parse_scene.cpp]
void parse_scene(Reader& reader, SceneContext& context);
/// Object expression of any kind (sphere, union, object { Name }, a declared object ...); empty when the next token
/// begins none. [parse_object.cpp]
std::optional<render::Object> parse_object(Reader& reader, SceneContext& context);

}  // namespace firstlight::parser
