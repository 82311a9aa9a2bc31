#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/scene/atmosphere.h"

namespace firstlight::parser {

// Blocks of what is around the objects. The word has been taken.

render::Fog parse_fog(Reader& reader, const Token& word);
render::Rainbow parse_rainbow(Reader& reader, const Token& word);
render::SkySphere parse_sky_sphere(Reader& reader, SceneContext& context, const Token& word);
/// The block after `background`.
void parse_background(Reader& reader, SceneContext& context, const Token& word);

/// If the next word begins one of them, or scene-wide media: takes it and adds it to the scene.
bool accept_atmosphere(Reader& reader, SceneContext& context);

}  // namespace firstlight::parser
