#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/texture/texture.h"

namespace firstlight::parser {

/// If the next word is one that scenes before version 3 have in a texture itself: takes it with its argument.
bool accept_old_words(Reader& reader, SceneContext& context, render::TextureLayer& layer);

// The words of one kind of block, outside of that block. [parse_pigment.cpp, parse_normal.cpp, parse_finish.cpp]
bool accept_bare_pigment(Reader& reader, SceneContext& context, render::Pigment& pigment);
bool accept_bare_normal(Reader& reader, SceneContext& context, render::Normal& normal);
bool accept_bare_finish(Reader& reader, render::Finish& finish);

}  // namespace firstlight::parser
