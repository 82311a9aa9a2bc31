#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"

namespace firstlight::parser {

/// A `camera` block, whose word has been taken; `start` is what it alters.
render::Camera parse_camera(Reader& reader, SceneContext& context, const Token& word, const render::Camera& start);

}  // namespace firstlight::parser
