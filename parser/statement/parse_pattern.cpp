#include "parser/statement/parse_common.h"
#include "parser/statement/parse_transform.h"
#include "parser/statement/parse_warp.h"
#include "parser/statement/pattern_owner.h"

#include <string>

namespace firstlight::parser {

using render::Patterning;
using render::PatternKind;
using render::WaveForm;

namespace {

bool accept_wave(Reader& reader, render::Wave& wave) {
  struct Row {
    Keyword word;
    WaveForm form;
  };
  static constexpr Row kForms[] = {{Keyword::ramp_wave, WaveForm::ramp},
                                   {Keyword::triangle_wave, WaveForm::triangle},
                                   {Keyword::sine_wave, WaveForm::sine},
                                   {Keyword::scallop_wave, WaveForm::scallop},
                                   {Keyword::cubic_wave, WaveForm::cubic}};
  for (const Row& row : kForms) {
    if (!reader.accept(row.word)) continue;
    wave.form = row.form;
    return true;
  }
  if (reader.accept(Keyword::poly_wave)) {
    wave.form = WaveForm::poly;
    if (reader.at_number()) wave.exponent = finite_number(reader, "poly_wave");
  } else if (reader.accept(Keyword::frequency)) {
    wave.frequency = finite_number(reader, "frequency");
  } else if (reader.accept(Keyword::phase)) {
    wave.phase = finite_number(reader, "phase");
  } else {
    return false;
  }
  return true;
}

bool accept_flag(Reader& reader, Patterning& pattern) {
  if (reader.accept(Keyword::no_bump_scale)) {
    pattern.keeps_bump_size = true;
    return true;
  }
  if (!reader.accept(Keyword::noise_generator)) return false;
  const Token& at = reader.peek();
  const int generator = integer(reader, "noise_generator");
  if (generator < 0 || generator > 3) reader.fail(at, "'noise_generator' must be 0, 1, 2 or 3");
  pattern.noise_generator |= generator;  // a second one adds its bits to the first, as in POV-Ray
  return true;
}

bool accept_modifier(Reader& reader, SceneContext& context, PatternOwner& owner) {
  // Most blocks end here, and so share what nothing changes.
  if (reader.next_is(Punctuation::right_brace)) return false;
  Patterning& pattern = owner.change_pattern();
  if (const auto transform = accept_transformation(reader)) {
    pattern.warps.transform(*transform);
    return true;
  }
  return accept_wave(reader, pattern.wave) || accept_warp(reader, pattern.warps) || accept_flag(reader, pattern) ||
         owner.accept_word(reader, context) || accept_pattern_parameter(reader, pattern);
}

}  // namespace

void parse_pattern(Reader& reader, SceneContext& context, PatternOwner& owner) {
  const Token& word = reader.peek();
  if (at_color(reader)) {
    if (owner.place() != PatternPlace::pigment && owner.place() != PatternPlace::density) {
      reader.fail(word, "a colour is for 'pigment' and 'density' only");
    }
    owner.parse_color(reader);
  } else if (const PatternKind kind = pattern_kind(reader, owner.place(), word); kind != PatternKind::none) {
    reader.take();
    parse_pattern_type(reader, context, owner, word, kind);
  }
  owner.parse_amount(reader);
  while (accept_modifier(reader, context, owner)) {
  }
  const Patterning& pattern = owner.pattern();
  if (pattern.kind == PatternKind::average && !owner.has_map()) reader.fail(word, "'average' needs a map");
  check_pattern_parameters(reader, word, pattern);
}

void check_map_allowed(Reader& reader, const Token& word, const Patterning& pattern, bool average_allowed) {
  const PatternKind kind = pattern.kind;
  const bool refused = render::is_list(kind) || render::is_image(kind) || kind == PatternKind::plain ||
                       (kind == PatternKind::average && !average_allowed);
  if (!refused) return;
  if (kind == PatternKind::plain) reader.fail(word, quoted(word) + " does not go with a single colour");
  reader.fail(word, quoted(word) + " does not go with '" + std::string(spelling(kind)) + "'");
}

}  // namespace firstlight::parser
