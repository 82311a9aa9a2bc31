#include "parser/statement/blend_map.h"
#include "parser/statement/old_texture.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_image.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_warp.h"
#include "parser/statement/pattern_owner.h"
#include "render/texture/default_map.h"

#include <algorithm>
#include <string>

namespace firstlight::parser {

using render::Feature;
using render::PatternKind;
using render::Pigment;

namespace {

class PigmentOwner final : public PatternOwner {
 public:
  explicit PigmentOwner(Pigment& pigment) : PatternOwner(PatternPlace::pigment), pigment_(pigment) {}

  const render::Patterning& pattern() const override { return pigment_.pattern; }
  render::Patterning& change_pattern() override { return pigment_.pattern.change(); }
  void parse_color(Reader& reader) override {
    render::make_plain(pigment_);
    pigment_.color = reader.color();
  }
  void parse_list(Reader& reader, SceneContext& context, std::size_t count) override;
  void parse_item(Reader& reader, SceneContext& context) override;
  void parse_image(Reader& reader, SceneContext& context, const Token& word) override {
    pigment_.pattern.change().parameters = parse_image_map(reader, context, word);
  }
  bool accept_word(Reader& reader, SceneContext& context) override;
  bool has_map() const override { return pigment_.pattern->pigments || !pigment_.pattern->map.empty(); }

 private:
  void set_map(render::ColorMap map);
  void set_pigments(Reader& reader, const Token& word, std::shared_ptr<const render::PigmentMap> pigments);

  Pigment& pigment_;
};

void PigmentOwner::set_map(render::ColorMap map) {
  render::PigmentPattern& pattern = pigment_.pattern.change();
  pattern.map = std::move(map);
  pattern.pigments = nullptr;
}

void PigmentOwner::set_pigments(Reader& reader, const Token& word, std::shared_ptr<const render::PigmentMap> pigments) {
  render::PigmentPattern& pattern = pigment_.pattern.change();
  nest(reader, word, pattern.depth, pigments->depth);
  pattern.pigments = std::move(pigments);
  pattern.map.clear();
}

/// Colours, or pigments. A list of single colours is the same whichever way it is written.
void PigmentOwner::parse_list(Reader& reader, SceneContext& context, std::size_t count) {
  render::ColorMap map = render::default_map(*pigment_.pattern);
  if (!reader.next_is(Keyword::pigment)) {
    for (auto entry = map.begin(); entry != map.end() && reader.at_expression(); ++entry) {
      entry->color = reader.color();
      reader.skip_comma();
    }
    return set_map(std::move(map));
  }
  const Token& word = reader.peek();
  const Pigment& missing = default_layer(context).pigment;
  auto list = parse_block_list<Pigment>(reader, Keyword::pigment, count, missing, false, [&](const Token& block) {
    return parse_pigment(reader, context, block, missing);
  });
  const bool single_colors = std::none_of(list->entries.begin(), list->entries.end(), [](const auto& entry) {
    return render::is_patterned(entry.value.pattern->kind);
  });
  if (!single_colors) {
    list->unrendered.add(feature_use(Feature::pigment_list, word));
    return set_pigments(reader, word, std::move(list));
  }
  for (std::size_t i = 0; i < count; ++i) map[i].color = list->entries[i].value.color;
  set_map(std::move(map));
}

void PigmentOwner::parse_item(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  set_pigments(reader, word,
               single_entry(parse_pigment_contents(reader, context, word, default_layer(context).pigment)));
}

bool PigmentOwner::accept_word(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::color_map)) {
    check_map_allowed(reader, word, pigment_.pattern, false);
    set_map(parse_color_map(reader, word));
  } else if (reader.accept(Keyword::pigment_map)) {
    check_map_allowed(reader, word, pigment_.pattern, true);
    set_pigments(reader, word,
                 parse_pigment_map(reader, context, word, pigment_.pattern->kind == PatternKind::average));
  } else if (reader.accept(Keyword::quick_color)) {
    const render::FilteredColor color = reader.color();
    pigment_.pattern.change().quick_color = color;
  } else {
    return false;
  }
  return true;
}

/// The patterns that version 1 had.
bool is_old_pattern(Keyword word) {
  switch (word) {
    case Keyword::agate:
    case Keyword::bozo:
    case Keyword::checker:
    case Keyword::gradient:
    case Keyword::granite:
    case Keyword::hexagon:
    case Keyword::image_map:
    case Keyword::leopard:
    case Keyword::mandel:
    case Keyword::marble:
    case Keyword::onion:
    case Keyword::spotted:
    case Keyword::square:
    case Keyword::triangular:
    case Keyword::wood:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool accept_bare_pigment(Reader& reader, SceneContext& context, Pigment& pigment) {
  PigmentOwner owner(pigment);
  const Token& word = reader.peek();
  if (at_color(reader)) {
    owner.parse_color(reader);
  } else if (word.kind == TokenKind::keyword && is_old_pattern(word.keyword)) {
    const render::WaveForm form = pigment.pattern->wave.form;  // no pattern had a wave of its own
    reader.take();
    parse_pattern_type(reader, context, owner, word, pattern_kind(reader, PatternPlace::pigment, word));
    pigment.pattern.change().wave.form = form;
  } else if (word.is(Keyword::warp) ||
             (!accept_warp(reader, pigment.pattern.change().warps) && !owner.accept_word(reader, context))) {
    return false;
  }
  return true;
}

std::shared_ptr<const render::PigmentMap> parse_pigment_map(Reader& reader, SceneContext& context, const Token& word,
                                                            bool average) {
  return parse_blend_map<Pigment>(reader, word, Feature::pigment_map, average, [&] {
    return parse_pigment_contents(reader, context, word, default_layer(context).pigment);
  });
}

namespace {

void alter_pigment_contents(Reader& reader, SceneContext& context, const Token& word, Pigment& pigment) {
  if (const auto declared = reader.accept_declared<Pigment>()) pigment = *declared;
  PigmentOwner owner(pigment);
  parse_pattern(reader, context, owner);
  if (pigment.pattern->kind == PatternKind::none) {
    reader.warn(word, "'pigment' has no colour or pattern as its first item");
  }
}

}  // namespace

Pigment parse_pigment_contents(Reader& reader, SceneContext& context, const Token& word, Pigment start) {
  alter_pigment_contents(reader, context, word, start);
  return start;
}

void alter_pigment(Reader& reader, SceneContext& context, const Token& word, Pigment& pigment) {
  reader.open_block(word);
  alter_pigment_contents(reader, context, word, pigment);
  reader.close_block();
}

Pigment parse_pigment(Reader& reader, SceneContext& context, const Token& word, Pigment start) {
  alter_pigment(reader, context, word, start);
  return start;
}

}  // namespace firstlight::parser
