#include "parser/parse_common.h"
#include "parser/parse_object.h"
#include "parser/parse_transform.h"

namespace firstlight::parser {

using render::Object;

namespace {

/// `photons { ... }` of a light. It speaks of photon maps, which a scene without them does not have.
void parse_photons(Reader& reader, const Token& word) {
  reader.open_block(word);
  for (;;) {
    if (reader.accept(Keyword::refraction) || reader.accept(Keyword::reflection)) {
      reader.number();
    } else if (!reader.accept(Keyword::area_light)) {
      break;
    }
  }
  reader.close_block();
}

/// Words of area lights, which change nothing in a point light.
bool accept_idle(Reader& reader) {
  if (reader.accept(Keyword::jitter)) return true;
  if (reader.next_is(Keyword::circular) || reader.next_is(Keyword::orient)) {
    const Token word = reader.take();
    reader.warn(word, quoted(word) + " does nothing without 'area_light'");
  } else if (reader.next_is(Keyword::area_illumination)) {
    const Token word = reader.take();
    reader.optional_number(1.0);
    reader.warn(word, "'area_illumination' does nothing without 'area_light'");
  } else if (reader.accept(Keyword::adaptive)) {
    reader.number();
  } else if (reader.accept(Keyword::media_attenuation) || reader.accept(Keyword::media_interaction)) {
    reader.optional_number(1.0);
  } else {
    return false;
  }
  return true;
}

bool accept_item(Reader& reader, Object& object) {
  if (const auto transform = accept_transformation(reader)) {
    render::place(object, *transform);
    return true;
  }
  if (accept_idle(reader)) return true;
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return false;
  switch (next.keyword) {
    case Keyword::shadowless:
      reader.take();
      object.light.shadowless = true;
      return true;
    case Keyword::fade_distance:
      reader.take();
      object.light.fade_distance = finite_number(reader, "fade_distance");
      return true;
    case Keyword::fade_power:
      reader.take();
      object.light.fade_power = finite_number(reader, "fade_power");
      return true;
    case Keyword::photons: {
      const Token word = reader.take();
      parse_photons(reader, word);
      return true;
    }
    case Keyword::point_at:
    case Keyword::tightness:
    case Keyword::radius:
    case Keyword::falloff: {
      const Token word = reader.take();
      reader.fail(word, quoted(word) + " does not go with a light that shines in all directions");
    }
    case Keyword::area_light:
    case Keyword::color_map:
    case Keyword::cylinder:
    case Keyword::looks_like:
    case Keyword::parallel:
    case Keyword::projected_through:
    case Keyword::spotlight:
      fail_unsupported(reader, reader.take());
    default:
      return false;
  }
}

}  // namespace

Object parse_light(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  if (auto declared = accept_declared_object(reader)) {
    parse_modifiers(reader, context, word, *declared);
    return std::move(*declared);
  }
  Object object;
  object.kind = Object::Kind::light;
  object.light.position = finite_vector(reader, "position of 'light_source'");
  reader.skip_comma();
  object.light.color = color_or_black(reader).rgb;
  while (accept_item(reader, object)) {
  }
  reader.close_block();
  return object;
}

}  // namespace firstlight::parser
