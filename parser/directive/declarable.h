#pragma once

#include "parser/directive/reader.h"
#include "parser/directive/scene_context.h"
#include "parser/text/value.h"

#include <optional>

namespace firstlight::parser {

// Directives ask these of the statements, which stand above them: parser/statement/ defines both.

/// One value to be declared, as after `#declare Name =`, an array element or a macro argument: object, texture,
/// pigment, finish, interior, material, color_map, camera, light_source, transform. Empty when the next token begins
/// none of these, nothing taken then; numbers and strings are the caller's. [parse_declared.cpp]
std::optional<Value> parse_declarable(Reader& reader, SceneContext& context);
/// `#default { texture | pigment | finish | camera }`; also for the old `default {` [parse_declared.cpp]
void parse_default(Reader& reader, SceneContext& context);

}  // namespace firstlight::parser
