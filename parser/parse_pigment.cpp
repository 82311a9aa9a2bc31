#include "parser/parse_common.h"
#include "parser/parse_surface.h"
#include "parser/parse_transform.h"
#include "render/texture/patterns.h"

#include <array>
#include <string>

namespace firstlight::parser {

using render::FilteredColor;
using render::Pigment;
using render::Rgb;
using render::WaveForm;

namespace {

/// A block under way: the pigment and what has been said about it.
struct Draft {
  Pigment pigment;
  bool typed = false;  ///< a colour or pattern was given
  bool solid = false;  ///< it is a single colour
};

const render::ColorMap& grey_map() {
  static const render::ColorMap map{{0.0, {Rgb(0.0f), 0.0f, 0.0f}}, {1.0, {Rgb(1.0f), 0.0f, 0.0f}}};
  return map;
}

/// Up to map.size() colours, or as many pigments of one colour each; what is not given stays as it is.
void parse_list(Reader& reader, SceneContext& context, render::ColorMap& map) {
  if (!reader.next_is(Keyword::pigment)) {
    for (auto entry = map.begin(); entry != map.end() && reader.at_expression(); ++entry) {
      entry->color = reader.color();
      reader.skip_comma();
    }
    return;
  }
  for (auto& entry : map) {
    entry.color = context.default_texture->layers[0].pigment.color;
    if (!reader.next_is(Keyword::pigment)) continue;
    const Token word = reader.take();
    const Pigment pigment = parse_default_pigment(reader, context, word);
    if (pigment.pattern) fail_unsupported(reader, word, "a patterned 'pigment' in a list");
    entry.color = pigment.color;
    reader.skip_comma();
  }
}

void parse_checker(Reader& reader, SceneContext& context, Draft& draft) {
  draft.pigment.pattern = render::make_checker();
  draft.pigment.stepped = true;
  draft.pigment.wave.frequency = 0.0;
  draft.pigment.map = {{0.0, {Rgb(0.0f, 0.0f, 1.0f), 0.0f, 0.0f}}, {1.0, {Rgb(0.0f, 1.0f, 0.0f), 0.0f, 0.0f}}};
  parse_list(reader, context, draft.pigment.map);
}

void parse_gradient(Reader& reader, Draft& draft) {
  draft.pigment.pattern = render::make_gradient(finite_vector(reader, "axis of 'gradient'"));
  if (draft.pigment.stepped) draft.pigment.map.clear();
  draft.pigment.stepped = false;
}

/// The pattern or colour that begins a pigment, if there is one.
void parse_type(Reader& reader, SceneContext& context, Draft& draft) {
  if (at_color(reader)) {
    draft.pigment.color = reader.color();
    draft.pigment.pattern = nullptr;
    draft.typed = draft.solid = true;
    return;
  }
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return;
  switch (next.keyword) {
    case Keyword::checker:
      reader.take();
      parse_checker(reader, context, draft);
      draft.typed = true;
      return;
    case Keyword::gradient:
      reader.take();
      parse_gradient(reader, draft);
      draft.typed = true;
      return;
#define PATTERN(word) case Keyword::word:
#include "parser/absent_patterns.def"
#undef PATTERN
      fail_unsupported(reader, reader.take());
    default:
      return;
  }
}

bool accept_wave(Reader& reader, render::Wave& wave) {
  if (reader.accept(Keyword::ramp_wave)) {
    wave.form = WaveForm::ramp;
  } else if (reader.accept(Keyword::triangle_wave)) {
    wave.form = WaveForm::triangle;
  } else if (reader.accept(Keyword::sine_wave)) {
    wave.form = WaveForm::sine;
  } else if (reader.accept(Keyword::scallop_wave)) {
    wave.form = WaveForm::scallop;
  } else if (reader.accept(Keyword::cubic_wave)) {
    wave.form = WaveForm::cubic;
  } else if (reader.accept(Keyword::poly_wave)) {
    wave.form = WaveForm::poly;
    wave.exponent = reader.optional_number(wave.exponent);
  } else if (reader.accept(Keyword::frequency)) {
    wave.frequency = finite_number(reader, "frequency");
  } else if (reader.accept(Keyword::phase)) {
    wave.phase = finite_number(reader, "phase");
  } else {
    return false;
  }
  return true;
}

/// Words that change nothing in the pigments there are.
bool accept_idle(Reader& reader) {
  if (reader.accept(Keyword::octaves) || reader.accept(Keyword::omega) || reader.accept(Keyword::lambda)) {
    reader.number();  // of turbulence
  } else if (reader.accept(Keyword::noise_generator)) {
    const Token at = reader.peek();
    const double generator = reader.number();
    if (!(generator >= 0.0 && generator < 4.0)) reader.fail(at, "'noise_generator' must be 0, 1, 2 or 3");
  } else if (reader.accept(Keyword::quick_color)) {
    reader.color();
  } else {
    return reader.accept(Keyword::no_bump_scale);
  }
  return true;
}

/// What may follow the type. False: the next token is none of it.
bool accept_modifier(Reader& reader, Draft& draft) {
  if (const auto transform = accept_transformation(reader)) {
    draft.pigment.placement = draft.pigment.placement.then(*transform);
    return true;
  }
  if (accept_wave(reader, draft.pigment.wave) || accept_idle(reader)) return true;
  if (reader.next_is(Keyword::color_map)) {
    const Token word = reader.take();
    if (draft.solid || draft.pigment.stepped)
      reader.fail(word, "'color_map' does not go with a single colour or a list of colours");
    draft.pigment.map = parse_color_map(reader, word);
    return true;
  }
  if (reader.next_is(Keyword::turbulence)) {
    const Token word = reader.take();
    const render::Vec3 amount = reader.vector3();
    if (amount != render::Vec3(0.0) && !draft.solid) fail_unsupported(reader, word);
    return true;
  }
  if (reader.next_is(Keyword::pigment_map) || reader.next_is(Keyword::warp)) fail_unsupported(reader, reader.take());
  return false;
}

}  // namespace

Pigment parse_pigment(Reader& reader, SceneContext& context, const Token& word, Pigment start, bool start_typed) {
  reader.open_block(word);
  Draft draft{std::move(start), start_typed, false};
  if (const auto declared = reader.accept_declared<Pigment>()) {
    draft.pigment = *declared;
    draft.typed = true;
  }
  draft.solid = draft.typed && !draft.pigment.pattern;
  parse_type(reader, context, draft);
  while (accept_modifier(reader, draft)) {
  }
  if (!draft.typed) reader.warn(word, "'pigment' has no colour or pattern as its first item");
  if (draft.pigment.pattern && draft.pigment.map.empty()) draft.pigment.map = grey_map();
  reader.close_block();
  return std::move(draft.pigment);
}

Pigment parse_default_pigment(Reader& reader, SceneContext& context, const Token& word) {
  return parse_pigment(reader, context, word, context.default_texture->layers[0].pigment,
                       context.default_pigment_given);
}

}  // namespace firstlight::parser
