#include "parser/statement/parse_common.h"
#include "parser/statement/parse_object.h"
#include "parser/statement/parse_photons.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace firstlight::parser {

using render::Object;

namespace {

/// Whether `sturm`, or `hierarchy`, may be said about an object.
bool takes_sturm(const Object& object) {
  static constexpr std::string_view kShapes[] = {"blob",       "cubic", "lathe",   "ovus", "poly",
                                                 "polynomial", "prism", "quartic", "sor",  "torus"};
  return object.kind == Object::Kind::shape && std::ranges::count(kShapes, object.word) > 0;
}

bool takes_hierarchy(const Object& object) {
  static constexpr std::string_view kShapes[] = {"blob", "height_field", "mesh", "mesh2"};
  return object.kind == Object::Kind::shape && std::ranges::count(kShapes, object.word) > 0;
}

/// Takes a word that goes with some objects only, and its flag.
bool parse_method(Reader& reader, bool allowed) {
  const Token& word = reader.take();
  if (!allowed) reader.fail(word, quoted(word) + " does not go with this object");
  return reader.optional_number(1.0) > 0.0;
}

/// Words that say how an object takes part in the picture. False: the word is none of them.
bool accept_flag(Reader& reader, Object& object) {
  if (reader.accept(Keyword::no_shadow)) {
    object.no_shadow = true;
  } else if (reader.accept(Keyword::no_image)) {
    object.no_image = reader.optional_flag();
  } else if (reader.accept(Keyword::no_reflection)) {
    object.no_reflection = reader.optional_flag();
  } else if (reader.accept(Keyword::hollow)) {
    object.hollow = reader.optional_flag() ? Object::Hollow::yes : Object::Hollow::no;
  } else if (reader.accept(Keyword::double_illuminate)) {
    object.double_illuminate = reader.optional_flag();
  } else if (reader.accept(Keyword::no_radiosity)) {
    object.no_radiosity = reader.optional_flag();
  } else if (reader.next_is(Keyword::sturm)) {
    object.sturm = parse_method(reader, takes_sturm(object) || object.sturm);
  } else if (reader.next_is(Keyword::hierarchy)) {
    object.hierarchy = parse_method(reader, takes_hierarchy(object));
  } else if (reader.next_is(Keyword::inverse)) {
    const Token& at = reader.take();
    if (object.patch) reader.warn(at, "'inverse' does nothing to a surface without an inside");
    invert(object);
  } else {
    return false;
  }
  return true;
}

/// The rest. False: the next token is no modifier.
bool accept_rare_modifier(Reader& reader, SceneContext& context, Object& object) {
  const Token& next = reader.peek();
  if (next.kind == TokenKind::identifier && at_color(reader)) {
    const Token& at = reader.peek();
    reader.color();
    reader.warn(at, "a colour belongs in a pigment; it is ignored here");
    return true;
  }
  if (next.kind != TokenKind::keyword) return false;
  switch (next.keyword) {
    case Keyword::bounded_by: {
      const Token& word = reader.take();
      parse_bounded_by(reader, context, word, object);
      return true;
    }
    case Keyword::clipped_by: {
      const Token& word = reader.take();
      parse_clipped_by(reader, context, word, object);
      return true;
    }
    case Keyword::split_union: {
      const Token& word = reader.take();
      if (object.kind != Object::Kind::union_ && object.word != "text") {
        reader.fail(word, "'split_union' is for unions only");
      }
      object.split_union = integer(reader, "split_union") != 0;
      return true;
    }
    case Keyword::photons: {
      const Token& word = reader.take();
      parse_object_photons(reader, word, object.extras.change().photons);
      return true;
    }
    case Keyword::radiosity: {
      const Token& word = reader.take();
      if (const auto importance = parse_importance(reader, word)) {
        object.extras.change().radiosity_importance = importance;
      }
      return true;
    }
    case Keyword::dtag:
      reader.take();
      reader.string();
      return true;
    case Keyword::uv_mapping: {
      const Token& word = reader.take();
      if (object.texture) reader.fail(word, "'uv_mapping' must stand before the texture");
      object.uv_mapping = true;
      object.extras.change().unrendered.add(feature_use(render::Feature::uv_mapping, word));
      return true;
    }
    case Keyword::cutaway_textures: {
      const Token& word = reader.take();
      if (object.kind != Object::Kind::intersection) {
        reader.fail(word, "'cutaway_textures' is for 'intersection' and 'difference' only");
      }
      object.cutaway_textures = true;
      object.cuts_away = true;
      return true;
    }
    case Keyword::light_source:
      reader.fail(reader.take(), "a 'light_source' cannot be a modifier of an object");
    default:
      if (!at_color(reader)) return false;
      const Token& at = reader.peek();
      reader.color();
      reader.warn(at, "a colour belongs in a pigment; it is ignored here");
      return true;
  }
}

}  // namespace

std::optional<double> parse_importance(Reader& reader, const Token& word) {
  std::optional<double> importance;
  reader.open_block(word);
  while (reader.accept(Keyword::importance)) {
    const Token& at = reader.peek();
    importance = reader.number();
    if (!(*importance > 0.0 && *importance <= 1.0)) reader.fail(at, "'importance' must be above 0 and at most 1");
  }
  reader.close_block();
  return importance;
}

void parse_modifiers(Reader& reader, SceneContext& context, const Token& word, Object& object) {
  while (!reader.next_is(Punctuation::right_brace)) {
    if (const auto transform = accept_transformation(reader)) {
      render::place(object, *transform);
    } else if (!accept_surface_modifier(reader, context, object) && !accept_flag(reader, object) &&
               !accept_rare_modifier(reader, context, object)) {
      break;
    }
  }
  render::finish_box(object);
  if (object.extras->interior_texture && !object.texture) {
    reader.fail(word, "an 'interior_texture' needs a 'texture' beside it");
  }
  reader.close_block();
}

}  // namespace firstlight::parser
