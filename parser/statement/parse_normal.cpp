#include "parser/statement/blend_map.h"
#include "parser/statement/old_texture.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_image.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/pattern_owner.h"

namespace firstlight::parser {

using render::Feature;
using render::Normal;
using render::PatternKind;

namespace {

/// `accuracy` of patterns with edges, whatever was said before.
constexpr double kDefaultAccuracy = 0.02;

class NormalOwner final : public PatternOwner {
 public:
  explicit NormalOwner(Normal& normal) : PatternOwner(PatternPlace::normal), normal_(normal) {}

  const render::Patterning& pattern() const override { return normal_.pattern; }
  render::Patterning& change_pattern() override { return normal_.pattern; }
  void parse_color(Reader&) override {}
  void parse_list(Reader& reader, SceneContext& context, std::size_t count) override;
  void parse_item(Reader& reader, SceneContext& context) override;
  void parse_image(Reader& reader, SceneContext& context, const Token& word) override {
    normal_.pattern.parameters = parse_bump_map(reader, context, word, normal_.amount);
  }
  void parse_amount(Reader& reader) override {
    reader.skip_comma();
    if (reader.at_number()) normal_.amount = finite_number(reader, "amount of 'normal'");
  }
  bool accept_word(Reader& reader, SceneContext& context) override;
  bool has_map() const override { return normal_.normals || normal_.slopes; }

 private:
  void set_normals(Reader& reader, const Token& word, std::shared_ptr<const render::NormalMap> normals);

  Normal& normal_;
};

const Normal* default_normal(const SceneContext& context) { return default_layer(context).extras->normal.get(); }

Normal start_of(const SceneContext& context, const Normal* start) {
  if (start == nullptr) start = default_normal(context);
  return start ? *start : Normal();
}

void NormalOwner::set_normals(Reader& reader, const Token& word, std::shared_ptr<const render::NormalMap> normals) {
  normal_.slopes = nullptr;
  if (normals) nest(reader, word, normal_.pattern.depth, normals->depth);
  normal_.normals = std::move(normals);
}

void NormalOwner::parse_list(Reader& reader, SceneContext& context, std::size_t count) {
  if (normal_.pattern.kind != PatternKind::object) normal_.accuracy = kDefaultAccuracy;
  const Token& word = reader.peek();
  set_normals(
      reader, word,
      parse_block_list<Normal>(reader, Keyword::normal, count, start_of(context, nullptr), true,
                               [&](const Token& block) { return parse_normal(reader, context, block, nullptr); }));
}

void NormalOwner::parse_item(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  set_normals(reader, word, single_entry(parse_normal_contents(reader, context, nullptr)));
}

bool NormalOwner::accept_word(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::accuracy)) {
    normal_.accuracy = finite_number(reader, "accuracy");
  } else if (reader.accept(Keyword::bump_size)) {
    normal_.amount = finite_number(reader, "bump_size");
  } else if (reader.accept(Keyword::slope_map)) {
    check_map_allowed(reader, word, normal_.pattern, false);
    normal_.slopes = parse_slope_map(reader, word);
    normal_.normals = nullptr;
  } else if (reader.accept(Keyword::normal_map)) {
    check_map_allowed(reader, word, normal_.pattern, true);
    if (normal_.pattern.kind == PatternKind::facets) reader.fail(word, "'normal_map' does not go with 'facets'");
    set_normals(reader, word, parse_normal_map(reader, context, word, normal_.pattern.kind == PatternKind::average));
  } else {
    return false;
  }
  return true;
}

PatternKind old_kind(Keyword word) {
  switch (word) {
    case Keyword::bumps:
      return PatternKind::bumps;
    case Keyword::bump_map:
      return PatternKind::bump_map;
    case Keyword::dents:
      return PatternKind::dents;
    case Keyword::ripples:
      return PatternKind::ripples;
    case Keyword::waves:
      return PatternKind::waves;
    case Keyword::wrinkles:
      return PatternKind::wrinkles;
    default:
      return PatternKind::none;
  }
}

}  // namespace

bool accept_bare_normal(Reader& reader, SceneContext& context, Normal& normal) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::frequency)) {
    normal.pattern.wave.frequency = finite_number(reader, "frequency");
    return true;
  }
  if (reader.accept(Keyword::phase)) {
    normal.pattern.wave.phase = finite_number(reader, "phase");
    return true;
  }
  const PatternKind kind = word.kind == TokenKind::keyword ? old_kind(word.keyword) : PatternKind::none;
  if (kind == PatternKind::none) return false;
  NormalOwner owner(normal);
  reader.take();
  parse_pattern_type(reader, context, owner, word, kind);
  if (kind != PatternKind::bump_map) normal.amount = finite_number(reader, "amount of " + quoted(word));
  normal.pattern.unrendered.add(feature_use(Feature::normal, word));
  return true;
}

std::shared_ptr<const render::SlopeMap> parse_slope_map(Reader& reader, const Token& word) {
  return parse_blend_map<render::SlopePoint>(reader, word, Feature::slope_map, false, [&] {
    const Token& at = reader.peek();
    const render::Vec2 point = reader.vector2();
    finite(reader, at, render::Vec3(point.x, point.y, 0.0), "entry of 'slope_map'");
    return render::SlopePoint{point.x, point.y};
  });
}

std::shared_ptr<const render::NormalMap> parse_normal_map(Reader& reader, SceneContext& context, const Token& word,
                                                          bool average) {
  return parse_blend_map<Normal>(reader, word, Feature::normal_map, average,
                                 [&] { return parse_normal_contents(reader, context, nullptr); });
}

Normal parse_normal_contents(Reader& reader, SceneContext& context, const Normal* start) {
  Normal normal;
  if (const auto declared = reader.accept_declared<Normal>()) {
    normal = *declared;
  } else {
    normal = start_of(context, start);
  }
  NormalOwner owner(normal);
  const Token& word = reader.peek();
  parse_pattern(reader, context, owner);
  if (normal.pattern.kind == PatternKind::none) reader.warn(word, "'normal' has no pattern as its first item");
  return normal;
}

Normal parse_normal(Reader& reader, SceneContext& context, const Token& word, const Normal* start) {
  reader.open_block(word);
  Normal normal = parse_normal_contents(reader, context, start);
  normal.pattern.unrendered.add(feature_use(Feature::normal, word));
  reader.close_block();
  return normal;
}

}  // namespace firstlight::parser
