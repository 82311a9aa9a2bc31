#include "parser/directive/declarable.h"
#include "parser/statement/parse_atmosphere.h"
#include "parser/statement/parse_camera.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_function.h"
#include "parser/statement/parse_object.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"
#include "parser/statement/statements.h"

#include <memory>
#include <utility>

namespace firstlight::parser {

namespace {

template <class T>
Value shared(T value) {
  return std::make_shared<const T>(std::move(value));
}

/// Textures in a row are the layers of one.
Value parse_textures(Reader& reader, SceneContext& context) {
  render::TexturePtr texture;
  while (reader.next_is(Keyword::texture)) {
    const Token& word = reader.take();
    texture = layered(reader, parse_texture(reader, context, word), texture);
  }
  return texture;
}

/// One thing said in `#default`. False: the next word is none.
bool accept_default(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  if (word.kind != TokenKind::keyword) return false;
  switch (word.keyword) {
    case Keyword::texture: {
      reader.take();
      const render::TexturePtr texture = parse_texture(reader, context, word);
      if (texture->layers.front().extras->patterned)
        reader.fail(word, "the default texture cannot be made of textures");
      if (texture->layers.size() != 1) reader.fail(word, "the default texture cannot have layers");
      context.default_texture = texture;
      return true;
    }
    case Keyword::pigment: {
      reader.take();
      auto texture = std::make_shared<render::Texture>(*context.default_texture);
      texture->layers[0].pigment = parse_pigment(reader, context, word, texture->layers[0].pigment);
      context.default_texture = texture;
      return true;
    }
    case Keyword::finish: {
      reader.take();
      auto texture = std::make_shared<render::Texture>(*context.default_texture);
      texture->layers[0].finish = parse_finish(reader, word, texture->layers[0].finish);
      context.default_texture = texture;
      return true;
    }
    case Keyword::camera:
      reader.take();
      context.default_camera = parse_camera(reader, context, word, context.default_camera);
      return true;
    case Keyword::radiosity:
      reader.take();
      if (const auto importance = parse_importance(reader, word)) {
        context.builder.settings().radiosity.default_importance = *importance;
      }
      return true;
    case Keyword::normal: {
      reader.take();
      auto texture = std::make_shared<render::Texture>(*context.default_texture);
      texture->layers[0].extras.change().normal = std::make_shared<render::Normal>(
          parse_normal(reader, context, word, texture->layers[0].extras->normal.get()));
      context.default_texture = texture;
      return true;
    }
    default:
      return false;
  }
}

}  // namespace

std::optional<Value> parse_declarable(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  if (word.kind != TokenKind::keyword) return std::nullopt;
  switch (word.keyword) {
    case Keyword::texture:
      return parse_textures(reader, context);
    case Keyword::pigment:
      reader.take();
      return shared(parse_pigment(reader, context, word, default_layer(context).pigment));
    case Keyword::finish:
      reader.take();
      return shared(parse_finish(reader, word, context.default_texture->layers[0].finish));
    case Keyword::interior:
      reader.take();
      return shared(parse_interior(reader, context, word, render::Interior()));
    case Keyword::material: {
      reader.take();
      Material material;
      parse_material(reader, context, word, material);
      return shared(std::move(material));
    }
    case Keyword::color_map:
      reader.take();
      return shared(parse_color_map(reader, word));
    case Keyword::camera:
      reader.take();
      return shared(parse_camera(reader, context, word, context.default_camera));
    case Keyword::function:
      reader.take();
      return parse_function(reader, context, word);
    case Keyword::spline:
      reader.take();
      return parse_spline(reader, word);
    case Keyword::transform:
      reader.take();
      return shared(parse_transform(reader, word));
    case Keyword::fog:
      reader.take();
      return shared(parse_fog(reader, word));
    case Keyword::rainbow:
      reader.take();
      return shared(parse_rainbow(reader, word));
    case Keyword::sky_sphere:
      reader.take();
      return shared(parse_sky_sphere(reader, context, word));
    case Keyword::normal:
      reader.take();
      return shared(parse_normal(reader, context, word, nullptr));
    case Keyword::density:
      reader.take();
      return shared(parse_density(reader, context, word));
    case Keyword::media:
      reader.take();
      return shared(parse_media(reader, context, word));
    case Keyword::pigment_map:
      reader.take();
      return parse_pigment_map(reader, context, word);
    case Keyword::normal_map:
      reader.take();
      return parse_normal_map(reader, context, word);
    case Keyword::slope_map:
      reader.take();
      return parse_slope_map(reader, word);
    case Keyword::texture_map:
      reader.take();
      return parse_texture_map(reader, context, word);
    case Keyword::density_map:
      reader.take();
      return parse_density_map(reader, context, word);
    default:
      break;
  }
  auto object = parse_object(reader, context);
  if (!object) return std::nullopt;
  return shared(std::move(*object));
}

void parse_default(Reader& reader, SceneContext& context) {
  Token word;
  word.text = "default";
  word.location = reader.peek().location;
  context.default_given = true;
  reader.open_block(word);
  while (accept_default(reader, context)) {
  }
  reader.close_block();
}

}  // namespace firstlight::parser
