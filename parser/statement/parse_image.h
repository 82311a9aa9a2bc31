#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/texture/pattern_parameters.h"

#include <string>
#include <vector>

namespace firstlight::parser {

/// A string that names a file to read, and where that file is; an error when there is none that may be read. The name
/// may leave out one of the extensions.
std::string parse_file_name(Reader& reader, const std::vector<std::string>& extensions);
/// The picture that comes next: its format and name, or a function, with what is said about its numbers.
render::ImageSource parse_image_source(Reader& reader, SceneContext& context, bool has_gamma);

// Blocks that lay a picture on a surface. The word has been taken.
render::ImageParameters parse_image_map(Reader& reader, SceneContext& context, const Token& word);
render::ImageParameters parse_image_pattern(Reader& reader, SceneContext& context, const Token& word);
/// `amount` is changed by bump_size.
render::ImageParameters parse_bump_map(Reader& reader, SceneContext& context, const Token& word, double& amount);
/// The picture of a material_map up to the first texture; not a block.
render::ImageParameters parse_material_image(Reader& reader, SceneContext& context);

}  // namespace firstlight::parser
