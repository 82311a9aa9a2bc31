#pragma once

#include "parser/directive/reader.h"
#include "render/math/transform.h"

#include <optional>

namespace firstlight::parser {

/// If the next word is `translate`, `rotate`, `scale`, `matrix` or `transform`: takes it with its argument.
std::optional<render::Transform> accept_transformation(Reader& reader);

/// Parses what follows the word `transform`: a declared one, or a block. The word has been taken.
render::Transform parse_transform(Reader& reader, const Token& word);

}  // namespace firstlight::parser
