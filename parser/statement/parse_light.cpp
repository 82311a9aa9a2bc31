#include "parser/statement/parse_common.h"
#include "parser/statement/parse_object.h"
#include "parser/statement/parse_photons.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace firstlight::parser {

using render::Feature;
using render::Light;
using render::LightKind;
using render::Object;

namespace {

/// A light under way. Transformations act where they stand: a `point_at` behind them is not moved.
struct Draft {
  Light light;
  Token beam_word, parallel_word, area_word, looks_like_word, projected_through_word;
};

/// The values that a kind of light begins with.
struct KindRow {
  std::string_view word;  ///< of `point` none: its name is no keyword
  LightKind kind;
  bool parallel;
  double radius;
  double falloff;
};

constexpr KindRow kKinds[] = {
#define LIGHT(kind, beam, parallel, radius, falloff) {#kind, LightKind::kind, parallel, radius, falloff},
#include "render/light/lights.def"
#undef LIGHT
};

bool has_axis(const Light& light) { return light.kind != LightKind::point || light.parallel; }

/// Fails when `word` is about the beam of a light that has none.
void require(Reader& reader, const Token& word, bool met) {
  if (!met) reader.fail(word, quoted(word) + " does not go with a light that shines in all directions");
}

/// Words that choose the beam; the last one counts.
bool accept_beam(Reader& reader, Draft& draft) {
  Light& light = draft.light;
  const Token& word = reader.peek();
  if (reader.accept(Keyword::parallel)) {
    light.parallel = true;
    draft.parallel_word = word;
    return true;
  }
  if (reader.accept(Keyword::shadowless)) {
    light.shadowless = true;
    light.kind = LightKind::point;
    draft.beam_word = word;
    return true;
  }
  const auto row = std::ranges::find(kKinds, word.kind == TokenKind::keyword ? word.text : "", &KindRow::word);
  if (row == std::end(kKinds)) return false;
  reader.take();
  light.shadowless = false;
  light.kind = row->kind;
  light.radius = row->radius;
  light.falloff = row->falloff;
  light.tightness = 0.0;
  draft.beam_word = word;
  if (row->parallel) {
    light.parallel = true;
    draft.parallel_word = word;
  }
  return true;
}

/// Words about the beam that has been chosen.
bool accept_axis(Reader& reader, Light& light) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::point_at)) {
    require(reader, word, has_axis(light));
    light.point_at = finite_vector(reader, "point_at");
    return true;
  }
  double* number = word.is(Keyword::tightness) ? &light.tightness
                   : word.is(Keyword::radius)  ? &light.radius
                   : word.is(Keyword::falloff) ? &light.falloff
                                               : nullptr;
  if (number == nullptr) return false;
  reader.take();
  require(reader, word, light.kind != LightKind::point);
  *number = finite_number(reader, word.text);
  return true;
}

int parse_size(Reader& reader) {
  const Token& at = reader.peek();
  const int size = integer(reader, "size of 'area_light'");
  if (size < 1) reader.fail(at, "the sizes of 'area_light' must be above 0");
  return size;
}

void parse_area(Reader& reader, Light& light) {
  render::AreaLight area;
  area.axis1 = finite_vector(reader, "axis of 'area_light'");
  reader.skip_comma();
  area.axis2 = finite_vector(reader, "axis of 'area_light'");
  reader.skip_comma();
  const Token& at = reader.peek();
  area.size1 = parse_size(reader);
  reader.skip_comma();
  area.size2 = parse_size(reader);
  constexpr int kMostPoints = 1 << 20;
  if (area.size1 > kMostPoints / area.size2) {
    reader.fail(at, "an 'area_light' may have at most " + std::to_string(kMostPoints) + " points");
  }
  light.area = area;
}

void warn_without_area(Reader& reader, const Token& word, const Light& light) {
  if (!light.area) reader.warn(word, quoted(word) + " does nothing without 'area_light'");
}

bool accept_area(Reader& reader, Draft& draft) {
  Light& light = draft.light;
  const Token& word = reader.peek();
  if (reader.accept(Keyword::area_light)) {
    draft.area_word = word;
    parse_area(reader, light);
  } else if (reader.accept(Keyword::jitter)) {
    light.jitter = true;
  } else if (reader.accept(Keyword::adaptive)) {
    light.adaptive = integer(reader, "adaptive");
  } else if (reader.accept(Keyword::circular)) {
    light.circular = true;
    warn_without_area(reader, word, light);
  } else if (reader.accept(Keyword::orient)) {
    light.orient = true;
    warn_without_area(reader, word, light);
  } else if (reader.accept(Keyword::area_illumination)) {
    light.area_illumination = reader.optional_number(1.0) > 0.0;
    warn_without_area(reader, word, light);
  } else {
    return false;
  }
  return true;
}

/// The object in the block that `word` opens, moved by `placement` before its modifiers.
std::shared_ptr<const Object> parse_inner_object(Reader& reader, SceneContext& context, const Token& word,
                                                 const render::Transform& placement) {
  reader.open_block(word);
  auto object = parse_object(reader, context);
  if (!object) reader.fail_expected("an object");
  render::place(*object, placement);
  parse_modifiers(reader, context, word, *object);
  return std::make_shared<const Object>(std::move(*object));
}

bool accept_object(Reader& reader, SceneContext& context, Draft& draft) {
  Light& light = draft.light;
  const Token& word = reader.peek();
  if (reader.accept(Keyword::looks_like)) {
    if (light.looks_like) reader.fail(word, "a 'light_source' can have only one 'looks_like'");
    draft.looks_like_word = word;
    auto shown = std::make_shared<Object>(
        *parse_inner_object(reader, context, word, render::Transform::translation(light.position)));
    shown->no_shadow = true;
    light.looks_like = std::move(shown);
  } else if (reader.accept(Keyword::projected_through)) {
    if (light.projected_through) reader.fail(word, "a 'light_source' can have only one 'projected_through'");
    draft.projected_through_word = word;
    light.projected_through = parse_inner_object(reader, context, word, render::Transform());
  } else {
    return false;
  }
  return true;
}

/// The colour of a light is the sum of the map's colours, each times its position. [POV-Ray 3.7]
render::Rgb sum_of(const render::ColorMap& map) {
  render::Rgb sum(0.0f);
  for (const auto& entry : map) sum += entry.color.rgb * static_cast<float>(entry.position);
  return sum;
}

bool accept_rest(Reader& reader, Light& light) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::fade_distance)) {
    light.fade_distance = finite_number(reader, "fade_distance");
  } else if (reader.accept(Keyword::fade_power)) {
    light.fade_power = finite_number(reader, "fade_power");
  } else if (reader.accept(Keyword::media_attenuation)) {
    light.media_attenuation = reader.optional_number(1.0) > 0.0;
  } else if (reader.accept(Keyword::media_interaction)) {
    light.media_interaction = reader.optional_number(1.0) > 0.0;
  } else if (reader.accept(Keyword::photons)) {
    parse_light_photons(reader, word, light);
  } else if (reader.accept(Keyword::color_map)) {
    light.color = sum_of(parse_color_map(reader, word));
  } else {
    return false;
  }
  return true;
}

/// Lights that turn are round, if they have points enough. [POV-Ray 3.7]
void make_oriented_circular(Reader& reader, const Token& word, Light& light) {
  if (!light.orient || !light.area || light.circular) return;
  if (light.area->size1 <= 1 || light.area->size2 <= 1) return;
  reader.warn(word, "an area light with 'orient' is 'circular'");
  light.circular = true;
}

/// Notes the features of the finished light.
void note_features(Draft& draft) {
  Light& light = draft.light;
  const auto note = [&](bool asked, Feature feature, const Token& word) {
    if (asked) light.unrendered.add(feature_use(feature, word));
  };
  note(light.kind == LightKind::spotlight, Feature::spotlight, draft.beam_word);
  note(light.kind == LightKind::cylinder, Feature::light_cylinder, draft.beam_word);
  note(light.parallel, Feature::light_parallel, draft.parallel_word);
  note(light.area.has_value(), Feature::area_light, draft.area_word);
  note(light.looks_like != nullptr, Feature::looks_like, draft.looks_like_word);
  note(light.projected_through != nullptr, Feature::projected_through, draft.projected_through_word);
}

}  // namespace

Object parse_light(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  if (auto declared = accept_declared_object(reader)) {
    parse_modifiers(reader, context, word, *declared);
    return std::move(*declared);
  }
  Draft draft;
  draft.light.position = finite_vector(reader, "position of 'light_source'");
  reader.skip_comma();
  draft.light.color = color_or_black(reader).rgb;
  for (;;) {
    if (const auto transform = accept_transformation(reader)) {
      draft.light = render::placed_with_objects(draft.light, *transform);
    } else if (!accept_beam(reader, draft) && !accept_axis(reader, draft.light) && !accept_area(reader, draft) &&
               !accept_object(reader, context, draft) && !accept_rest(reader, draft.light)) {
      break;
    }
  }
  reader.close_block();
  const Light& light = draft.light;
  if (light.circular && (!light.area || light.area->size1 <= 1 || light.area->size2 <= 1)) {
    reader.fail(word, "a 'circular' light needs an 'area_light' of more than one point each way");
  }
  make_oriented_circular(reader, word, draft.light);
  note_features(draft);
  Object object;
  object.kind = Object::Kind::light;
  for (const auto& part : {light.looks_like, light.projected_through}) {
    if (part) count_in(reader, word, object, *part);
  }
  object.extras.change().light = std::move(draft.light);
  return object;
}

}  // namespace firstlight::parser
