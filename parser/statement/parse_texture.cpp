#include "parser/statement/old_texture.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"

#include <algorithm>
#include <string>
#include <unordered_map>

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
  TexturePtr finished() { return std::move(texture_); }

 private:
  Texture& change() {
    if (!own_) texture_ = own_ = std::make_shared<Texture>(*texture_);
    return *own_;
  }
  TexturePtr texture_;
  std::shared_ptr<Texture> own_;
};

/// If the next word is `pigment`, `normal` or `finish`: takes its block, which alters the top layer.
bool accept_part(Reader& reader, SceneContext& context, Draft& draft) {
  const Token& word = reader.peek();
  switch (word.keyword) {
    case Keyword::pigment:
      reader.take();
      alter_pigment(reader, context, word, draft.change_top().pigment);
      return true;
    case Keyword::finish:
      reader.take();
      draft.change_top().finish = kept_once(context, parse_finish(reader, word, draft.top().finish));
      return true;
    case Keyword::normal:
      reader.take();
      draft.change_top().extras.change().normal =
          std::make_shared<render::Normal>(parse_normal(reader, context, word, draft.top().extras->normal.get()));
      return true;
    default:
      return false;
  }
}

/// Declared parts may stand in a texture without a block of their own.
bool accept_declared_part(Reader& reader, Draft& draft) {
  if (const auto pigment = reader.accept_declared<render::Pigment>()) {
    draft.change_top().pigment = *pigment;
  } else if (const auto finish = reader.accept_declared<render::Finish>()) {
    draft.change_top().finish = *finish;
  } else if (const auto normal = reader.accept_declared<render::Normal>()) {
    draft.change_top().extras.change().normal = normal;
  } else {
    return false;
  }
  return true;
}

void set_no_bump_scale(Draft& draft) {
  render::LayerExtras& top = draft.change_top().extras.change();
  top.keeps_bump_size = true;
  if (!top.patterned) return;
  auto pattern = std::make_shared<render::TexturePattern>(*top.patterned);
  pattern->pattern.keeps_bump_size = true;
  top.patterned = std::move(pattern);
}

/// Accepts what textures had in version 1, beside blocks.
bool accept_old(Reader& reader, SceneContext& context, Draft& draft) {
  if (const auto declared = reader.accept_declared<Texture>()) {
    reader.warn(reader.peek(), "this texture replaces what stands before it");
    draft = Draft(declared);
    return true;
  }
  return !draft.top().extras->patterned && accept_old_words(reader, context, draft.change_top());
}

/// Transformations, which apply to all layers. True: there were some.
bool parse_placement(Reader& reader, Draft& draft) {
  bool any = false;
  for (;;) {
    if (const auto transform = accept_transformation(reader)) {
      draft.move(*transform);
      any = true;
    } else if (reader.accept(Keyword::no_bump_scale)) {
      set_no_bump_scale(draft);
    } else {
      return any;
    }
  }
}

void filter_to_transmit(FilteredColor& color) {
  color.transmit += color.filter;
  color.filter = 0.0f;
}

/// Turns filter into transmit wherever a pigment has it. Maps are shared, so each is changed once.
class Untinted {
 public:
  void change(render::Pigment& pigment) {
    if (!render::is_patterned(pigment.pattern->kind)) return filter_to_transmit(pigment.color);
    render::PigmentPattern& pattern = pigment.pattern.change();
    for (auto& entry : pattern.map) filter_to_transmit(entry.color);
    if (pattern.pigments) pattern.pigments = changed(pattern.pigments);
  }

 private:
  using MapPtr = std::shared_ptr<const render::PigmentMap>;
  MapPtr changed(const MapPtr& map) {
    if (const auto known = done_.find(map); known != done_.end()) return known->second;
    auto result = std::make_shared<render::PigmentMap>(*map);
    for (auto& entry : result->entries) change(entry.value);
    return done_[map] = result;
  }
  std::unordered_map<MapPtr, MapPtr> done_;
};

/// A texture that is one layer made of textures can be neither over nor under another.
void check_layers(Reader& reader, const TexturePtr& upper, const TexturePtr& lower) {
  const Token& at = reader.peek();
  if (lower && upper->layers.size() + lower->layers.size() > kMaxLayers) {
    reader.fail(at, "a texture cannot have more than " + std::to_string(kMaxLayers) + " layers");
  }
  if (lower && lower->layers.front().extras->patterned)
    reader.fail(at, "a texture cannot lie over one that is made of textures");
  if (lower && upper->layers.front().extras->patterned)
    reader.fail(at, "a texture made of textures cannot lie over another");
}

}  // namespace

TexturePtr layered(Reader& reader, const TexturePtr& upper, const TexturePtr& lower) {
  if (!upper) return lower;
  check_layers(reader, upper, lower);
  const bool old_rules = language_version(reader) <= 310;
  if (!lower && !(old_rules && upper->layers.size() > 1)) return upper;
  auto result = std::make_shared<Texture>(*upper);
  // before 3.5 the light that passed a layer onto the next one was not tinted
  const std::size_t untinted = !old_rules ? 0 : lower ? upper->layers.size() : upper->layers.size() - 1;
  Untinted change;
  for (std::size_t i = 0; i < untinted; ++i) change.change(result->layers[i].pigment);
  if (lower) {
    for (const TextureLayer& layer : lower->layers) result->layers.push_back(layer);
  }
  return result;
}

TexturePtr parse_texture_contents(Reader& reader, SceneContext& context) {
  const auto declared = reader.accept_declared<Texture>();
  Draft draft(declared ? declared : context.default_texture);
  if (draft.top().extras->patterned) {
    parse_placement(reader, draft);
    return draft.finished();
  }
  bool changed = declared != nullptr;
  while (accept_declared_part(reader, draft)) changed = true;
  const bool is_old = language_version(reader) < 300;
  while (accept_part(reader, context, draft) || parse_placement(reader, draft) ||
         (is_old && accept_old(reader, context, draft))) {
    changed = true;
  }
  if (changed) return draft.finished();
  const TexturePtr patterned = parse_texture_pattern(reader, context);
  if (!patterned) return draft.finished();
  Draft whole(patterned);
  parse_placement(reader, whole);
  return whole.finished();
}

TexturePtr parse_texture(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  TexturePtr texture = parse_texture_contents(reader, context);
  reader.close_block();
  return texture;
}

namespace {

/// Makes the transformations that came after a texture part of it.
void settle(TexturePtr& texture, Transform& placement) {
  if (placement.is_identity()) return;
  texture = moved(texture, placement);
  placement = Transform();
}

void parse_object_texture(Reader& reader, SceneContext& context, TexturePtr& texture, Transform& placement) {
  const Token& word = reader.take();
  const TexturePtr upper = parse_texture(reader, context, word);
  settle(texture, placement);
  texture = layered(reader, upper, texture);
}

void parse_object_parts(Reader& reader, SceneContext& context, Object& object) {
  settle(object.texture, object.texture_placement);
  if (object.texture && object.texture->layers.front().extras->patterned) {
    const Token& word = reader.peek();
    reader.fail(word, quoted(word) + " cannot alter a texture that is made of textures");
  }
  Draft draft(object.texture ? object.texture : context.default_texture);
  while (accept_part(reader, context, draft)) {
  }
  object.texture = draft.finished();
}

void parse_object_material(Reader& reader, SceneContext& context, Object& object) {
  const Token& word = reader.take();
  render::ObjectExtras& extras = object.extras.change();
  settle(object.texture, object.texture_placement);
  settle(extras.interior_texture, extras.interior_texture_placement);
  Material material;
  material.texture = object.texture;
  material.interior_texture = extras.interior_texture;
  material.interior = extras.interior;
  parse_material(reader, context, word, material);
  object.texture = material.texture;
  extras.interior_texture = material.interior_texture;
  extras.interior = material.interior;
}

/// Objects in the patterns of surfaces count as part of the object, for its depth.
void deepen(Object& object) {
  const auto with = [&](const TexturePtr& texture) {
    if (!texture) return;
    object.textured = true;
    object.depth = std::max(object.depth, depth_of(*texture));
  };
  with(object.texture);
  if (object.extras.is_initial()) return;
  with(object.extras->interior_texture);
  if (object.extras->interior) object.depth = std::max(object.depth, depth_of(**object.extras->interior));
}

}  // namespace

bool accept_surface_modifier(Reader& reader, SceneContext& context, Object& object) {
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return false;
  switch (next.keyword) {
    case Keyword::texture:
      parse_object_texture(reader, context, object.texture, object.texture_placement);
      break;
    case Keyword::interior_texture: {
      render::ObjectExtras& extras = object.extras.change();
      parse_object_texture(reader, context, extras.interior_texture, extras.interior_texture_placement);
      break;
    }
    case Keyword::pigment:
    case Keyword::finish:
    case Keyword::normal:
      parse_object_parts(reader, context, object);
      break;
    case Keyword::interior: {
      const Token& word = reader.take();
      auto& interior = object.extras.change().interior;
      interior = parse_interior(reader, context, word, interior.value_or(render::Shared<render::Interior>()));
      break;
    }
    case Keyword::material:
      parse_object_material(reader, context, object);
      break;
    default:
      return false;
  }
  deepen(object);
  return true;
}

}  // namespace firstlight::parser
