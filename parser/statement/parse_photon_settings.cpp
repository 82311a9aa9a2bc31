#include "parser/statement/parse_common.h"
#include "parser/statement/parse_settings.h"

#include <algorithm>
#include <string>

namespace firstlight::parser {

using render::PhotonSettings;

namespace {

/// `radius least, factor, least in media, factor in media`, of which each may be left out.
void parse_radius(Reader& reader, PhotonSettings& settings) {
  double* const numbers[] = {&settings.surface_radius.least, &settings.surface_radius.factor,
                             &settings.media_radius.least, &settings.media_radius.factor};
  const double defaults[] = {-1.0, 1.0, -1.0, 1.0};
  for (std::size_t i = 0; i < std::size(numbers); ++i) {
    if (i > 0) reader.skip_comma();
    *numbers[i] = reader.at_number() ? finite_number(reader, "radius") : defaults[i];
  }
}

void parse_expand(Reader& reader, const Token& word, PhotonSettings& settings) {
  settings.expand_tolerance = finite_number(reader, "expand_thresholds");
  reader.skip_comma();
  settings.expand_min = finite_number(reader, "expand_thresholds");
  if (settings.expand_tolerance < 0.0 || settings.expand_min < 0.0) {
    reader.warn(word, "a number of 'expand_thresholds' is negative; it is taken as 0");
  }
  settings.expand_tolerance = std::max(settings.expand_tolerance, 0.0);
  settings.expand_min = std::max(settings.expand_min, 0.0);
}

void parse_file(Reader& reader, const Token& word, PhotonSettings& settings) {
  const bool load = word.is(Keyword::load_file);
  if (!settings.file.empty()) {
    reader.warn(word, load == settings.load ? "a file was given before; this one counts"
                                            : "a photon map cannot be both loaded and saved; this word counts");
  }
  settings.file = reader.string();
  settings.load = load;
}

void parse_media_steps(Reader& reader, const Token& word, PhotonSettings& settings) {
  settings.max_media_steps = integer(reader, "media");
  reader.skip_comma();
  if (settings.max_media_steps < 0) reader.fail(word, "the number of steps of 'media' cannot be negative");
  settings.media_spacing_factor = reader.at_number() ? finite_number(reader, "media") : 1.0;
  if (settings.media_spacing_factor <= 0.0) reader.fail(word, "the factor of 'media' must be above 0");
}

bool accept_item(Reader& reader, PhotonSettings& settings) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::spacing)) {
    settings.spacing = finite_number(reader, "spacing");
  } else if (reader.accept(Keyword::count)) {
    settings.count = integer(reader, "count");
  } else if (reader.accept(Keyword::gather)) {
    settings.gather_min = integer(reader, "gather");
    reader.skip_comma();
    settings.gather_max = integer(reader, "gather");
  } else if (reader.accept(Keyword::radius)) {
    parse_radius(reader, settings);
  } else if (reader.accept(Keyword::expand_thresholds)) {
    parse_expand(reader, word, settings);
  } else if (reader.accept(Keyword::jitter)) {
    settings.jitter = finite_number(reader, "jitter");
  } else if (reader.accept(Keyword::autostop)) {
    settings.autostop = finite_number(reader, "autostop");
  } else if (reader.accept(Keyword::adc_bailout)) {
    settings.adc_bailout = finite_number(reader, "adc_bailout");
  } else if (reader.accept(Keyword::max_trace_level)) {
    settings.max_trace_level = integer(reader, "max_trace_level");
  } else if (reader.accept(Keyword::load_file) || reader.accept(Keyword::save_file)) {
    parse_file(reader, word, settings);
  } else if (reader.accept(Keyword::media)) {
    parse_media_steps(reader, word, settings);
  } else {
    return false;
  }
  return true;
}

}  // namespace

void parse_photon_settings(Reader& reader, SceneContext& context, const Token& word) {
  PhotonSettings settings;
  reader.open_block(word);
  while (accept_item(reader, settings)) {
  }
  reader.close_block();
  settings.enabled = settings.gather_max > 0;
  if (settings.enabled) {
    if (settings.gather_min < 0) reader.fail(word, "the first number of 'gather' cannot be negative");
    if (settings.gather_min > settings.gather_max) {
      reader.fail(word, "the first number of 'gather' must not be above the second");
    }
    context.builder.settings().unrendered.add(feature_use(render::Feature::photons, word));
  }
  context.builder.settings().photons = std::move(settings);
}

}  // namespace firstlight::parser
