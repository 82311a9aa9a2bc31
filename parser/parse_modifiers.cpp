#include "parser/parse_common.h"
#include "parser/parse_object.h"
#include "parser/parse_surface.h"
#include "parser/parse_transform.h"

#include <string>

namespace firstlight::parser {

using render::Object;

namespace {

/// `photons { ... }` of an object. It speaks of photon maps, which a scene without them does not have.
void parse_photons(Reader& reader, const Token& word) {
  reader.open_block(word);
  for (;;) {
    if (reader.accept(Keyword::target) || reader.accept(Keyword::pass_through) || reader.accept(Keyword::collect)) {
      reader.optional_number(1.0);
    } else if (reader.accept(Keyword::refraction) || reader.accept(Keyword::reflection)) {
      reader.number();
    } else {
      break;
    }
  }
  reader.close_block();
}

/// `radiosity { importance n }` of an object: without radiosity it means nothing.
void parse_importance(Reader& reader, const Token& word) {
  reader.open_block(word);
  while (reader.accept(Keyword::importance)) {
    const Token at = reader.peek();
    const double importance = reader.number();
    if (!(importance > 0.0 && importance <= 1.0)) reader.fail(at, "'importance' must be above 0 and at most 1");
  }
  reader.close_block();
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
    object.hollow = reader.optional_flag();
  } else if (reader.accept(Keyword::double_illuminate)) {
    object.double_illuminate = reader.optional_flag();
  } else if (reader.accept(Keyword::no_radiosity) || reader.accept(Keyword::sturm) ||
             reader.accept(Keyword::hierarchy)) {
    reader.optional_flag();  // about methods, not about the picture
  } else if (reader.next_is(Keyword::inverse)) {
    const Token at = reader.take();
    if (object.patch) reader.warn(at, "'inverse' does nothing to a surface without an inside");
    object.inverted = !object.inverted;
  } else {
    return false;
  }
  return true;
}

/// The rest. False: the next token is no modifier.
bool accept_rare_modifier(Reader& reader, SceneContext& context, Object& object) {
  const Token& next = reader.peek();
  if (next.kind == TokenKind::identifier && at_color(reader)) {
    const Token at = reader.peek();
    reader.color();
    reader.warn(at, "a colour belongs in a pigment; it is ignored here");
    return true;
  }
  if (next.kind != TokenKind::keyword) return false;
  switch (next.keyword) {
    case Keyword::bounded_by: {
      const Token word = reader.take();
      parse_bounded_by(reader, context, word, object);
      return true;
    }
    case Keyword::clipped_by: {
      const Token word = reader.take();
      parse_clipped_by(reader, context, word, object);
      return true;
    }
    case Keyword::split_union: {
      const Token word = reader.take();
      if (object.kind != Object::Kind::union_) reader.fail(word, "'split_union' is for unions only");
      reader.number();
      return true;
    }
    case Keyword::photons: {
      const Token word = reader.take();
      parse_photons(reader, word);
      return true;
    }
    case Keyword::radiosity: {
      const Token word = reader.take();
      parse_importance(reader, word);
      return true;
    }
    case Keyword::dtag:
      reader.take();
      reader.string();
      return true;
    case Keyword::uv_mapping:
    case Keyword::cutaway_textures:
      fail_unsupported(reader, reader.take());
    case Keyword::light_source:
      reader.fail(reader.take(), "a 'light_source' cannot be a modifier of an object");
    default:
      if (!at_color(reader)) return false;
      const Token at = reader.peek();
      reader.color();
      reader.warn(at, "a colour belongs in a pigment; it is ignored here");
      return true;
  }
}

}  // namespace

void parse_modifiers(Reader& reader, SceneContext& context, const Token& word, Object& object) {
  for (;;) {
    if (const auto transform = accept_transformation(reader)) {
      render::place(object, *transform);
    } else if (!accept_surface_modifier(reader, context, object) && !accept_flag(reader, object) &&
               !accept_rare_modifier(reader, context, object)) {
      break;
    }
  }
  if (object.interior_texture && !object.texture) {
    reader.fail(word, "an 'interior_texture' needs a 'texture' beside it");
  }
  reader.close_block();
}

}  // namespace firstlight::parser
