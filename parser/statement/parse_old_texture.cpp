// Textures of scenes written before version 3: the words of pigments, normals and finishes stand in the texture itself.
#include "parser/statement/old_texture.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"

namespace firstlight::parser {

namespace {

/// A normal is made by the first word about one.
render::Normal normal_of(const render::TextureLayer& layer) {
  return layer.extras->normal ? *layer.extras->normal : render::Normal();
}

bool accept_normal(Reader& reader, SceneContext& context, render::TextureLayer& layer) {
  render::Normal normal = normal_of(layer);
  if (!accept_bare_normal(reader, context, normal)) return false;
  layer.extras.change().normal = std::make_shared<const render::Normal>(std::move(normal));
  return true;
}

}  // namespace

bool accept_old_words(Reader& reader, SceneContext& context, render::TextureLayer& layer) {
  const Token& word = reader.peek();
  if (accept_bare_pigment(reader, context, layer.pigment) || accept_normal(reader, context, layer) ||
      accept_bare_finish(reader, layer.finish.change())) {
    return true;
  }
  if (!reader.at_number()) return false;
  render::Finish& finish = layer.finish.change();
  finish.crand = finite_number(reader, "crand");
  finish.unrendered.add(feature_use(render::Feature::crand, word));
  reader.warn(word, "a number in a texture is taken as 'crand', which should be written");
  return true;
}

}  // namespace firstlight::parser
