#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "parser/text/value.h"
#include "render/scene/object.h"
#include "render/texture/media.h"
#include "render/texture/texture.h"

#include <memory>
#include <optional>

namespace firstlight::parser {

// Blocks that describe surfaces and matter. Each is called with its word taken and its `{` next, and leaves the reader
// behind the `}`. `start` is what the block alters, unless it begins with a declared one of its kind. Those called
// `..._contents` read what stands between the braces, as the entries of maps have it.

render::Pigment parse_pigment(Reader& reader, SceneContext& context, const Token& word, render::Pigment start);
/// The same where it stands, for textures are made in great numbers.
void alter_pigment(Reader& reader, SceneContext& context, const Token& word, render::Pigment& pigment);
render::Pigment parse_pigment_contents(Reader& reader, SceneContext& context, const Token& word, render::Pigment start);
/// `start` may be null: then the default texture's normal is altered, or an even one.
render::Normal parse_normal(Reader& reader, SceneContext& context, const Token& word, const render::Normal* start);
render::Normal parse_normal_contents(Reader& reader, SceneContext& context, const render::Normal* start);
render::Finish parse_finish(Reader& reader, const Token& word, render::Finish start);
/// `finish` as part of a texture. Where the last one was the same, as in a loop, that is taken again.
render::Shared<render::Finish> kept_once(SceneContext& context, render::Finish finish);
render::TexturePtr parse_texture(Reader& reader, SceneContext& context, const Token& word);
render::TexturePtr parse_texture_contents(Reader& reader, SceneContext& context);
render::Density parse_density(Reader& reader, SceneContext& context, const Token& word);
render::Density parse_density_contents(Reader& reader, SceneContext& context);
render::Media parse_media(Reader& reader, SceneContext& context, const Token& word);
render::Interior parse_interior(Reader& reader, SceneContext& context, const Token& word, render::Interior start);
void parse_material(Reader& reader, SceneContext& context, const Token& word, Material& material);

// Maps. `average`: for the pattern of that name, whose entries have weights.
render::ColorMap parse_color_map(Reader& reader, const Token& word);
std::shared_ptr<const render::PigmentMap> parse_pigment_map(Reader& reader, SceneContext& context, const Token& word,
                                                            bool average = false);
std::shared_ptr<const render::NormalMap> parse_normal_map(Reader& reader, SceneContext& context, const Token& word,
                                                          bool average = false);
std::shared_ptr<const render::SlopeMap> parse_slope_map(Reader& reader, const Token& word);
std::shared_ptr<const render::TextureMap> parse_texture_map(Reader& reader, SceneContext& context, const Token& word,
                                                            bool average = false);
std::shared_ptr<const render::DensityMap> parse_density_map(Reader& reader, SceneContext& context, const Token& word,
                                                            bool average = false);

/// The pigment and the texture that `#default` has set: what further ones alter.
inline const render::TextureLayer& default_layer(const SceneContext& context) {
  return context.default_texture->layers.front();
}

/// `upper` laid over `lower`; either may be null.
render::TexturePtr layered(Reader& reader, const render::TexturePtr& upper, const render::TexturePtr& lower);
/// A texture made of textures by a pattern, by `tiles` or `material_map`; null if the next word begins none.
render::TexturePtr parse_texture_pattern(Reader& reader, SceneContext& context);

/// If the next word is about the surface or the matter of an object (`texture`, `pigment`, `finish`, `interior`,
/// `material` ...): takes it with its block.
bool accept_surface_modifier(Reader& reader, SceneContext& context, render::Object& object);

}  // namespace firstlight::parser
