#include "parser/parse_common.h"
#include "parser/parse_surface.h"
#include "parser/parse_transform.h"

#include <string>

namespace firstlight::parser {

using render::FilteredColor;
using render::Object;
using render::Texture;
using render::TextureLayer;
using render::TexturePtr;
using render::Transform;

namespace {

constexpr std::size_t kMaxLayers = 1000;

/// A texture that is shared until something in it is changed.
class Draft {
 public:
  explicit Draft(TexturePtr start) : texture_(std::move(start)) {}

  const TextureLayer& top() const { return texture_->layers.front(); }
  TextureLayer& change_top() { return change().layers.front(); }
  void move(const Transform& transform) {
    texture_ = moved(texture_, transform);
    own_ = nullptr;
  }
  TexturePtr finished() { return texture_; }

 private:
  Texture& change() {
    if (!own_) texture_ = own_ = std::make_shared<Texture>(*texture_);
    return *own_;
  }
  TexturePtr texture_;
  std::shared_ptr<Texture> own_;
};

/// If the next word is `pigment` or `finish`: takes its block, which alters the top layer. `typed`: see
/// parse_pigment().
bool accept_part(Reader& reader, SceneContext& context, Draft& draft, bool typed) {
  if (reader.next_is(Keyword::pigment)) {
    const Token word = reader.take();
    draft.change_top().pigment = parse_pigment(reader, context, word, draft.top().pigment, typed);
    return true;
  }
  if (reader.next_is(Keyword::finish)) {
    const Token word = reader.take();
    draft.change_top().finish = parse_finish(reader, word, draft.top().finish);
    return true;
  }
  if (reader.next_is(Keyword::normal)) fail_unsupported(reader, reader.take());
  return false;
}

/// Textures made of other textures, none of which can be rendered.
void refuse_patterned(Reader& reader) {
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return;
  switch (next.keyword) {
    case Keyword::tiles:
    case Keyword::material_map:
    case Keyword::texture_map:
    case Keyword::checker:
    case Keyword::gradient:
#define PATTERN(word) case Keyword::word:
#include "parser/absent_patterns.def"
#undef PATTERN
    {
      const Token word = reader.take();
      fail_unsupported(reader, word, "a texture made of textures by " + quoted(word));
    }
    default:
      return;
  }
}

void filter_to_transmit(FilteredColor& color) {
  color.transmit += color.filter;
  color.filter = 0.0f;
}

void filter_to_transmit(render::Pigment& pigment) {
  filter_to_transmit(pigment.color);
  for (auto& entry : pigment.map) filter_to_transmit(entry.color);
}

}  // namespace

TexturePtr moved(const TexturePtr& texture, const Transform& transform) {
  if (!texture || transform.is_identity()) return texture;
  auto result = std::make_shared<Texture>(*texture);
  for (TextureLayer& layer : result->layers) layer.pigment.placement = layer.pigment.placement.then(transform);
  return result;
}

TexturePtr layered(Reader& reader, const TexturePtr& upper, const TexturePtr& lower) {
  if (!upper) return lower;
  if (lower && upper->layers.size() + lower->layers.size() > kMaxLayers) {
    reader.fail(reader.peek(), "a texture cannot have more than " + std::to_string(kMaxLayers) + " layers");
  }
  const bool old_rules = language_version(reader) <= 310;
  if (!lower && !(old_rules && upper->layers.size() > 1)) return upper;
  auto result = std::make_shared<Texture>(*upper);
  // before 3.5 the light that passed a layer onto the next one was not tinted
  const std::size_t untinted = !old_rules ? 0 : lower ? upper->layers.size() : upper->layers.size() - 1;
  for (std::size_t i = 0; i < untinted; ++i) filter_to_transmit(result->layers[i].pigment);
  if (lower) result->layers.insert(result->layers.end(), lower->layers.begin(), lower->layers.end());
  return result;
}

TexturePtr parse_texture(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  const auto declared = reader.accept_declared<Texture>();
  Draft draft(declared ? declared : context.default_texture);
  bool typed = declared || context.default_pigment_given;
  bool changed = declared != nullptr;
  // declared parts may stand here without a block of their own
  for (;; changed = true) {
    if (const auto pigment = reader.accept_declared<render::Pigment>()) {
      draft.change_top().pigment = *pigment;
      typed = true;
    } else if (const auto finish = reader.accept_declared<render::Finish>()) {
      draft.change_top().finish = *finish;
    } else {
      break;
    }
  }
  for (;;) {
    if (accept_part(reader, context, draft, typed)) {
      changed = typed = true;
    } else if (const auto transform = accept_transformation(reader)) {
      draft.move(*transform);
      changed = true;
    } else if (!reader.accept(Keyword::no_bump_scale)) {
      break;
    }
  }
  if (!changed) refuse_patterned(reader);
  reader.close_block();
  return draft.finished();
}

bool accept_surface_modifier(Reader& reader, SceneContext& context, Object& object) {
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return false;
  // what is there already, with the transformations that came after it made part of it
  const auto settle = [](TexturePtr& texture, Transform& placement) {
    texture = moved(texture, placement);
    placement = Transform();
  };
  switch (next.keyword) {
    case Keyword::texture: {
      const Token word = reader.take();
      const TexturePtr upper = parse_texture(reader, context, word);
      settle(object.texture, object.texture_placement);
      object.texture = layered(reader, upper, object.texture);
      object.textured = true;
      return true;
    }
    case Keyword::interior_texture: {
      const Token word = reader.take();
      const TexturePtr upper = parse_texture(reader, context, word);
      settle(object.interior_texture, object.interior_texture_placement);
      object.interior_texture = layered(reader, upper, object.interior_texture);
      object.textured = true;
      return true;
    }
    case Keyword::pigment:
    case Keyword::finish:
    case Keyword::normal: {
      settle(object.texture, object.texture_placement);
      const bool typed = object.texture || context.default_pigment_given;
      Draft draft(object.texture ? object.texture : context.default_texture);
      while (accept_part(reader, context, draft, typed)) {
      }
      object.texture = draft.finished();
      object.textured = true;
      return true;
    }
    case Keyword::interior: {
      const Token word = reader.take();
      object.interior = parse_interior(reader, word, object.interior);
      return true;
    }
    case Keyword::material: {
      const Token word = reader.take();
      settle(object.texture, object.texture_placement);
      settle(object.interior_texture, object.interior_texture_placement);
      Material material;
      material.texture = object.texture;
      material.interior_texture = object.interior_texture;
      if (object.interior) material.interior = std::make_shared<const render::Interior>(*object.interior);
      parse_material(reader, context, word, material);
      object.texture = material.texture;
      object.interior_texture = material.interior_texture;
      object.interior.reset();
      if (material.interior) object.interior = *material.interior;
      object.textured = object.textured || object.texture;
      return true;
    }
    default:
      return false;
  }
}

}  // namespace firstlight::parser
