#pragma once

#include "parser/directive/reader.h"
#include "render/shape/shape.h"

namespace firstlight::parser {

/// How parse_object() reads the geometry of a shape: from behind the `{` to the first modifier. `word` is for messages.
/// Null: there is nothing to see (a degenerate triangle), after a warning.
using ShapeReader = render::ShapePtr (*)(Reader& reader, const Token& word);

#define SHAPE(word, function) render::ShapePtr function(Reader& reader, const Token& word_token);
#define PATCH(word, function) render::ShapePtr function(Reader& reader, const Token& word_token);
#define RICH(word, function)
#include "parser/shapes.def"
#undef RICH
#undef PATCH
#undef SHAPE

}  // namespace firstlight::parser
