#pragma once

#include "parser/reader.h"
#include "parser/statements.h"
#include "parser/value.h"
#include "render/scene/object.h"
#include "render/texture/texture.h"

#include <optional>

namespace firstlight::parser {

// Blocks that describe surfaces and matter. Each is called with its word taken and its `{` next, and leaves the reader
// behind the `}`. `start` is what the block alters, unless it begins with a declared one of its kind.

/// `start_typed`: the start has got a colour or pattern from the scene text.
render::Pigment parse_pigment(Reader& reader, SceneContext& context, const Token& word, render::Pigment start,
                              bool start_typed);
/// The pigment statement's default start.
render::Pigment parse_default_pigment(Reader& reader, SceneContext& context, const Token& word);
render::Finish parse_finish(Reader& reader, const Token& word, render::Finish start);
render::TexturePtr parse_texture(Reader& reader, SceneContext& context, const Token& word);
render::ColorMap parse_color_map(Reader& reader, const Token& word);
render::Interior parse_interior(Reader& reader, const Token& word, const std::optional<render::Interior>& start);
void parse_material(Reader& reader, SceneContext& context, const Token& word, Material& material);

/// `texture` with every pigment moved on. Null stays null.
render::TexturePtr moved(const render::TexturePtr& texture, const render::Transform& transform);
/// `upper` laid over `lower`; either may be null.
render::TexturePtr layered(Reader& reader, const render::TexturePtr& upper, const render::TexturePtr& lower);

/// If the next word is about the surface or the matter of an object (`texture`, `pigment`, `finish`, `interior`,
/// `material` ...): takes it with its block.
bool accept_surface_modifier(Reader& reader, SceneContext& context, render::Object& object);

}  // namespace firstlight::parser
