// Textures that are made of textures.
#include "parser/statement/blend_map.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_image.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/pattern_owner.h"

namespace firstlight::parser {

using render::Feature;
using render::PatternKind;
using render::TextureMap;
using render::TexturePattern;
using render::TexturePtr;

namespace {

class TextureOwner final : public PatternOwner {
 public:
  explicit TextureOwner(TexturePattern& texture) : PatternOwner(PatternPlace::texture), texture_(texture) {}

  const render::Patterning& pattern() const override { return texture_.pattern; }
  render::Patterning& change_pattern() override { return texture_.pattern; }
  void parse_color(Reader&) override {}
  void parse_list(Reader& reader, SceneContext& context, std::size_t count) override {
    const Token& word = reader.peek();
    auto list = parse_block_list<TexturePtr>(reader, Keyword::texture, count, context.default_texture, false,
                                             [&](const Token& block) { return parse_texture(reader, context, block); });
    list->unrendered.add(feature_use(Feature::texture_list, word));
    set_textures(reader, word, std::move(list));
  }
  void parse_item(Reader& reader, SceneContext& context) override {
    const Token& word = reader.peek();
    set_textures(reader, word, single_entry(parse_texture_contents(reader, context)));
  }
  bool accept_word(Reader& reader, SceneContext& context) override {
    const Token& word = reader.peek();
    if (!reader.accept(Keyword::texture_map)) return false;
    check_map_allowed(reader, word, texture_.pattern, true);
    set_textures(reader, word, parse_texture_map(reader, context, word, texture_.pattern.kind == PatternKind::average));
    return true;
  }
  bool has_map() const override { return texture_.textures != nullptr; }

 private:
  void set_textures(Reader& reader, const Token& word, std::shared_ptr<const TextureMap> textures) {
    nest(reader, word, texture_.pattern.depth, textures->depth);
    texture_.textures = std::move(textures);
  }

  TexturePattern& texture_;
};

TexturePtr texture_of(TexturePattern pattern) {
  auto texture = std::make_shared<render::Texture>();
  texture->layers.push_back({});
  texture->layers.front().extras.change().patterned = std::make_shared<const TexturePattern>(std::move(pattern));
  return texture;
}

/// One or more textures, the later ones over the earlier.
TexturePtr parse_layers(Reader& reader, SceneContext& context) {
  if (!reader.next_is(Keyword::texture)) reader.fail_expected("'texture'");
  TexturePtr texture;
  while (reader.next_is(Keyword::texture)) {
    const Token& word = reader.take();
    texture = layered(reader, parse_texture(reader, context, word), texture);
  }
  return texture;
}

void start_pattern(TexturePattern& pattern, PatternKind kind, const Token& word) {
  pattern.pattern.kind = kind;
  pattern.pattern.wave.frequency = 0.0;
  pattern.pattern.unrendered.add(feature_use(feature_of(kind), word));
}

/// `tiles { texture ... tile2 texture ... }`, an old form of checker; its cells are the other way round.
TexturePtr parse_tiles(Reader& reader, SceneContext& context, const Token& word) {
  TexturePattern pattern;
  start_pattern(pattern, PatternKind::tiles, word);
  reader.open_block(word);
  const TexturePtr first = parse_layers(reader, context);
  if (!reader.accept(Keyword::tile2)) reader.fail_expected("'tile2'");
  const TexturePtr second = parse_layers(reader, context);
  reader.close_block();
  auto map = std::make_shared<TextureMap>();
  append(*map, 0.0, second);
  append(*map, 1.0, first);
  nest(reader, word, pattern.pattern.depth, map->depth);
  pattern.textures = std::move(map);
  return texture_of(std::move(pattern));
}

TexturePtr parse_material_map(Reader& reader, SceneContext& context, const Token& word) {
  constexpr std::size_t kMostMaterials = 65536;
  TexturePattern pattern;
  start_pattern(pattern, PatternKind::material_map, word);
  reader.open_block(word);
  pattern.pattern.parameters = parse_material_image(reader, context);
  if (!reader.next_is(Keyword::texture)) reader.fail_expected("'texture'");
  auto map = std::make_shared<TextureMap>();
  while (reader.next_is(Keyword::texture)) {
    const Token& at = reader.take();
    if (map->entries.size() >= kMostMaterials) reader.fail(at, "a 'material_map' has too many textures");
    append(*map, static_cast<double>(map->entries.size()), parse_texture(reader, context, at));
  }
  reader.close_block();
  nest(reader, word, pattern.pattern.depth, map->depth);
  pattern.textures = std::move(map);
  return texture_of(std::move(pattern));
}

}  // namespace

std::shared_ptr<const TextureMap> parse_texture_map(Reader& reader, SceneContext& context, const Token& word,
                                                    bool average) {
  return parse_blend_map<TexturePtr>(reader, word, Feature::texture_map, average,
                                     [&] { return parse_texture_contents(reader, context); });
}

TexturePtr parse_texture_pattern(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::tiles)) return parse_tiles(reader, context, word);
  if (reader.accept(Keyword::material_map)) return parse_material_map(reader, context, word);
  TexturePattern pattern;
  TextureOwner owner(pattern);
  parse_pattern(reader, context, owner);
  if (pattern.pattern.kind == PatternKind::none && !pattern.textures) return nullptr;
  if (pattern.pattern.kind == PatternKind::none) reader.fail(word, "'texture_map' needs a pattern before it");
  if (!pattern.textures) reader.fail(word, "a texture with a pattern needs a 'texture_map'");
  return texture_of(std::move(pattern));
}

}  // namespace firstlight::parser
