#include "parser/parse_settings.h"

#include "parser/interpreter.h"
#include "parser/parse_common.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace firstlight::parser {

namespace {

constexpr int kMaxTraceLevel = 256;  ///< POV-Ray's own limit

/// `srgb`, or the exponent of a power law.
void parse_assumed_gamma(Reader& reader, const Token& word) {
  render::WorkingGamma gamma = render::WorkingGamma::srgb;
  double exponent = 1.0;
  if (!reader.accept(Keyword::srgb)) {
    const Token at = reader.peek();
    exponent = finite_number(reader, "assumed_gamma");
    if (exponent <= 0.0) reader.fail(at, "'assumed_gamma' must be above 0");
    if (exponent < 1.0) reader.warn(at, fmt::format("'assumed_gamma' is {}; was {} meant?", exponent, 1.0 / exponent));
    gamma = exponent == 1.0 ? render::WorkingGamma::linear : render::WorkingGamma::power;
  }
  if (!reader.interpreter().set_assumed_gamma(gamma, exponent)) {
    reader.warn(word, "'assumed_gamma' was given before; this one is ignored");
  }
}

void parse_charset(Reader& reader) {
  if (!reader.accept(Keyword::ascii) && !reader.accept(Keyword::utf8) && !reader.accept(Keyword::sys)) {
    reader.fail_expected("'ascii', 'utf8' or 'sys'");
  }
}

/// Settings of what pictures of supported scenes do not have.
bool accept_idle(Reader& reader) {
  if (reader.next_is(Keyword::number_of_waves)) {
    const Token word = reader.take();
    if (integer(reader, "number_of_waves") <= 0)
      reader.warn(word, "'number_of_waves' must be above 0; it is taken as 1");
  } else if (reader.accept(Keyword::noise_generator)) {
    const Token at = reader.peek();
    const int generator = integer(reader, "noise_generator");
    if (generator < 1 || generator > 3) reader.fail(at, "'noise_generator' must be 1, 2 or 3");
  } else if (reader.accept(Keyword::irid_wavelength)) {
    reader.color();
  } else if (reader.accept(Keyword::mm_per_unit)) {
    reader.number();
  } else if (reader.next_is(Keyword::hf_gray_16)) {
    const Token word = reader.take();
    reader.optional_flag();
    reader.warn(word, "'hf_gray_16' is ignored, as it is by POV-Ray 3.7");
  } else if (reader.accept(Keyword::charset)) {
    parse_charset(reader);
  } else {
    return false;
  }
  return true;
}

bool accept_setting(Reader& reader, SceneContext& context) {
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return false;
  switch (next.keyword) {
    case Keyword::assumed_gamma:
      parse_assumed_gamma(reader, reader.take());
      return true;
    case Keyword::ambient_light:
      reader.take();
      context.builder.settings().ambient_light = reader.color().rgb;
      return true;
    case Keyword::max_trace_level:
      parse_max_trace_level(reader, context, reader.take());
      return true;
    case Keyword::max_intersections:
      parse_max_intersections(reader, reader.take());
      return true;
    case Keyword::adc_bailout:
      reader.take();
      context.builder.settings().adc_bailout = finite_number(reader, "adc_bailout");
      return true;
    case Keyword::photons:
    case Keyword::radiosity:
    case Keyword::subsurface:
      fail_unsupported(reader, reader.take());
    default:
      return accept_idle(reader);
  }
}

}  // namespace

void parse_global_settings(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  while (accept_setting(reader, context)) {
  }
  reader.close_block();
}

void parse_background(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  const render::FilteredColor color = color_or_black(reader);
  // behind a background that lets light pass there is black
  const float kept = effective_language_version(reader) < 370 ? 1.0f : 1.0f - color.transmit;
  context.builder.settings().background = color.rgb * kept;
  reader.close_block();
}

void parse_max_trace_level(Reader& reader, SceneContext& context, const Token& word) {
  const int level = integer(reader, "max_trace_level");
  if (level > kMaxTraceLevel) {
    reader.warn(word,
                "'max_trace_level' is " + std::to_string(level) + "; it is taken as " + std::to_string(kMaxTraceLevel));
  }
  context.builder.settings().max_trace_level = std::clamp(level, 1, kMaxTraceLevel);
}

void parse_max_intersections(Reader& reader, const Token& word) {
  reader.number();
  if (language_version(reader) >= 370) reader.warn(word, "'max_intersections' has no effect any more");
}

}  // namespace firstlight::parser
