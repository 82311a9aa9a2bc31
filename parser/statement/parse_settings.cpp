#include "parser/statement/parse_settings.h"

#include "parser/directive/interpreter.h"
#include "parser/statement/parse_common.h"

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
    const Token& at = reader.peek();
    exponent = finite_number(reader, "assumed_gamma");
    if (exponent <= 0.0) reader.fail(at, "'assumed_gamma' must be above 0");
    if (exponent < 1.0) reader.warn(at, fmt::format("'assumed_gamma' is {}; was {} meant?", exponent, 1.0 / exponent));
    gamma = exponent == 1.0 ? render::WorkingGamma::linear : render::WorkingGamma::power;
  }
  if (!reader.interpreter().language().set_assumed_gamma(gamma, exponent)) {
    reader.warn(word, "'assumed_gamma' was given before; this one is ignored");
  }
}

render::Charset parse_charset(Reader& reader) {
  if (reader.accept(Keyword::ascii)) return render::Charset::ascii;
  if (reader.accept(Keyword::utf8)) return render::Charset::utf8;
  if (reader.accept(Keyword::sys)) return render::Charset::system;
  reader.fail_expected("'ascii', 'utf8' or 'sys'");
}

void parse_subsurface(Reader& reader, const Token& word, render::SubsurfaceSettings& settings) {
  settings.enabled = true;
  reader.open_block(word);
  for (;;) {
    if (reader.accept(Keyword::samples)) {
      settings.diffuse_samples = integer(reader, "samples");
      reader.skip_comma();
      settings.single_samples = integer(reader, "samples");
    } else if (reader.accept(Keyword::radiosity)) {
      settings.radiosity = integer(reader, "radiosity") != 0;
    } else {
      break;
    }
  }
  reader.close_block();
}

/// Settings of single surfaces, patterns and strings.
bool accept_detail(Reader& reader, render::Settings& settings) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::number_of_waves)) {
    settings.number_of_waves = integer(reader, "number_of_waves");
    if (settings.number_of_waves <= 0) {
      reader.warn(word, "'number_of_waves' must be above 0; it is taken as 1");
      settings.number_of_waves = 1;
    }
  } else if (reader.accept(Keyword::noise_generator)) {
    const Token& at = reader.peek();
    const int generator = integer(reader, "noise_generator");
    if (generator < 1 || generator > 3) reader.fail(at, "'noise_generator' must be 1, 2 or 3");
    reader.interpreter().language().set_noise_generator(generator);
  } else if (reader.accept(Keyword::irid_wavelength)) {
    settings.irid_wavelength = reader.color().rgb;
  } else if (reader.accept(Keyword::mm_per_unit)) {
    settings.mm_per_unit = finite_number(reader, "mm_per_unit");
  } else if (reader.accept(Keyword::hf_gray_16)) {
    reader.optional_flag();
    reader.warn(word, "'hf_gray_16' is ignored, as it is by POV-Ray 3.7");
  } else if (reader.accept(Keyword::charset)) {
    settings.charset = parse_charset(reader);
    reader.interpreter().language().set_charset(settings.charset);
  } else if (reader.accept(Keyword::subsurface)) {
    parse_subsurface(reader, word, settings.subsurface);
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
      parse_photon_settings(reader, context, reader.take());
      return true;
    case Keyword::radiosity:
      parse_radiosity(reader, context, reader.take());
      return true;
    default:
      return accept_detail(reader, context.builder.settings());
  }
}

}  // namespace

void parse_global_settings(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  while (accept_setting(reader, context)) {
  }
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
