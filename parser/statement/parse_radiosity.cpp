#include "parser/statement/parse_common.h"
#include "parser/statement/parse_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace firstlight::parser {

using render::RadiositySettings;

namespace {

constexpr int kMostNearest = 20;  // POV-Ray's own limits
constexpr int kDeepestRecursion = 20;
constexpr int kDirectionPool = 1600;

/// A number that must be above 0, and at most `high`.
double positive(Reader& reader, const Token& word, double high = 1e300) {
  const Token& at = reader.peek();
  const double value = finite_number(reader, word.text);
  if (value <= 0.0) reader.fail(at, quoted(word) + " must be above 0");
  if (value > high) reader.fail(at, fmt::format("{} must be at most {}", quoted(word), high));
  return value;
}

bool flag(Reader& reader, const Token& word) { return integer(reader, word.text) != 0; }

void parse_count(Reader& reader, const Token& word, RadiositySettings& settings) {
  settings.count = static_cast<int>(positive(reader, word, 1e9));
  if (settings.count < 1) reader.fail(word, "'count' must be above 0");
  reader.skip_comma();
  const int pool = std::max(kDirectionPool, settings.count);
  const Token& at = reader.peek();
  settings.direction_pool_size = reader.at_number() ? integer(reader, "count") : pool;
  if (settings.direction_pool_size < settings.count) {
    reader.fail(at, "the second number of 'count' must not be smaller than the first");
  }
}

void parse_nearest_count(Reader& reader, RadiositySettings& settings) {
  const Token& at = reader.peek();
  settings.nearest_count = integer(reader, "nearest_count");
  if (settings.nearest_count < 1 || settings.nearest_count > kMostNearest) {
    reader.fail(at, fmt::format("'nearest_count' must be from 1 to {}", kMostNearest));
  }
  reader.skip_comma();
  settings.nearest_count_pretrace = reader.at_number() ? integer(reader, "nearest_count") : 0;
  if (settings.nearest_count_pretrace < 0 || settings.nearest_count_pretrace >= settings.nearest_count) {
    reader.fail(at, "the second number of 'nearest_count' must be smaller than the first, and not negative");
  }
}

void parse_file(Reader& reader, const Token& word) {
  reader.string();
  reader.warn(
      word, quoted(word) + " of 'radiosity' is ignored, as it is by POV-Ray 3.7: it is an option of the command line");
}

/// Accepts a word that bounds the work.
bool accept_limit(Reader& reader, RadiositySettings& settings) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::count)) {
    parse_count(reader, word, settings);
  } else if (reader.accept(Keyword::nearest_count)) {
    parse_nearest_count(reader, settings);
  } else if (reader.accept(Keyword::recursion_limit)) {
    const Token& at = reader.peek();
    settings.recursion_limit = integer(reader, "recursion_limit");
    if (settings.recursion_limit < 1 || settings.recursion_limit > kDeepestRecursion) {
      reader.fail(at, fmt::format("'recursion_limit' must be from 1 to {}", kDeepestRecursion));
    }
  } else if (reader.accept(Keyword::pretrace_start)) {
    settings.pretrace_start = positive(reader, word, 1.0);
  } else if (reader.accept(Keyword::pretrace_end)) {
    settings.pretrace_end = positive(reader, word, 1.0);
  } else if (reader.accept(Keyword::always_sample)) {
    settings.always_sample = flag(reader, word);
  } else if (reader.accept(Keyword::load_file) || reader.accept(Keyword::save_file)) {
    parse_file(reader, word);
  } else {
    return false;
  }
  return true;
}

/// Accepts a word about the light.
bool accept_quality(Reader& reader, RadiositySettings& settings, RadiosityText& text) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::brightness)) {
    settings.brightness = positive(reader, word);
  } else if (reader.accept(Keyword::error_bound)) {
    settings.error_bound = positive(reader, word);
  } else if (reader.accept(Keyword::gray_threshold)) {
    settings.gray_threshold = finite_number(reader, "gray_threshold");
    if (settings.gray_threshold < 0.0 || settings.gray_threshold > 1.0) {
      reader.fail(word, "'gray_threshold' must be from 0 to 1");
    }
  } else if (reader.accept(Keyword::low_error_factor)) {
    settings.low_error_factor = positive(reader, word);
  } else if (reader.accept(Keyword::maximum_reuse)) {
    settings.maximum_reuse = positive(reader, word);
    text.maximum_reuse = true;
  } else if (reader.accept(Keyword::minimum_reuse)) {
    settings.minimum_reuse = finite_number(reader, "minimum_reuse");
    if (settings.minimum_reuse < 0.0) reader.fail(word, "'minimum_reuse' cannot be negative");
    text.minimum_reuse = true;
  } else if (reader.accept(Keyword::max_sample)) {
    settings.max_sample = finite_number(reader, "max_sample");
  } else if (reader.accept(Keyword::adc_bailout)) {
    settings.adc_bailout = positive(reader, word);
  } else if (reader.accept(Keyword::normal)) {
    settings.normal = flag(reader, word);
  } else if (reader.accept(Keyword::media)) {
    settings.media = flag(reader, word);
  } else if (reader.accept(Keyword::subsurface)) {
    settings.subsurface = flag(reader, word);
  } else {
    return false;
  }
  return true;
}

}  // namespace

void parse_radiosity(Reader& reader, SceneContext& context, const Token& word) {
  render::Settings& settings = context.builder.settings();
  if (!settings.radiosity.enabled && language_version(reader) < 350) {
    reader.warn(word, "'radiosity' turns radiosity on, as it does since version 3.5");
  }
  settings.radiosity.enabled = true;
  context.radiosity.word = word;
  settings.unrendered.add(feature_use(render::Feature::radiosity, word));
  reader.open_block(word);
  while (accept_limit(reader, settings.radiosity) || accept_quality(reader, settings.radiosity, context.radiosity)) {
  }
  reader.close_block();
}

void check_radiosity(Reader& reader, SceneContext& context) {
  const RadiosityText& text = context.radiosity;
  RadiositySettings& settings = context.builder.settings().radiosity;
  if (settings.pretrace_end > settings.pretrace_start) {
    reader.fail(text.word,
                fmt::format("'pretrace_end' of 'radiosity' ({}) must not be greater than 'pretrace_start' ({})",
                            settings.pretrace_end, settings.pretrace_start));
  }
  if (!(settings.minimum_reuse > 0.5 * settings.maximum_reuse)) return;
  // The bound that the scene does not say gives way.
  if (!text.minimum_reuse) {
    settings.minimum_reuse = 0.5 * settings.maximum_reuse;
    reader.warn(text.word, fmt::format("'maximum_reuse' is less than twice 'minimum_reuse', which becomes {}",
                                       settings.minimum_reuse));
  } else if (!text.maximum_reuse) {
    settings.maximum_reuse = 2.0 * settings.minimum_reuse;
    reader.warn(text.word, fmt::format("'minimum_reuse' is more than half of 'maximum_reuse', which becomes {}",
                                       settings.maximum_reuse));
  } else if (settings.minimum_reuse >= settings.maximum_reuse) {
    reader.fail(text.word, fmt::format("'maximum_reuse' of 'radiosity' ({}) must be greater than 'minimum_reuse' ({})",
                                       settings.maximum_reuse, settings.minimum_reuse));
  } else {
    reader.warn(text.word, "'maximum_reuse' should be at least twice 'minimum_reuse'");
  }
}

}  // namespace firstlight::parser
