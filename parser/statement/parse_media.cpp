#include "parser/statement/blend_map.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"
#include "parser/statement/pattern_owner.h"

#include <string>

namespace firstlight::parser {

using render::Density;
using render::Media;
using render::PatternKind;

namespace {

constexpr std::size_t kMostDensities = 1000;

class DensityOwner final : public PatternOwner {
 public:
  explicit DensityOwner(Density& density) : PatternOwner(PatternPlace::density), density_(density) {}

  const render::Patterning& pattern() const override { return density_.pattern; }
  render::Patterning& change_pattern() override { return density_.pattern; }
  void parse_color(Reader& reader) override {
    density_.pattern.kind = PatternKind::plain;
    density_.color = reader.color();
  }
  void parse_list(Reader& reader, SceneContext& context, std::size_t count) override {
    const Token& word = reader.peek();
    set_densities(reader, word,
                  parse_block_list<Density>(reader, Keyword::density, count, Density(), false,
                                            [&](const Token& block) { return parse_density(reader, context, block); }));
  }
  void parse_item(Reader& reader, SceneContext& context) override {
    const Token& word = reader.peek();
    set_densities(reader, word, single_entry(parse_density_contents(reader, context)));
  }
  bool accept_word(Reader& reader, SceneContext& context) override;
  bool has_map() const override { return density_.densities || !density_.map.empty(); }

 private:
  void set_densities(Reader& reader, const Token& word, std::shared_ptr<const render::DensityMap> densities) {
    nest(reader, word, density_.pattern.depth, densities->depth);
    density_.densities = std::move(densities);
    density_.map.clear();
  }

  Density& density_;
};

bool DensityOwner::accept_word(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::color_map)) {
    check_map_allowed(reader, word, density_.pattern, false);
    density_.map = parse_color_map(reader, word);
    density_.densities = nullptr;
  } else if (reader.accept(Keyword::density_map)) {
    check_map_allowed(reader, word, density_.pattern, true);
    set_densities(reader, word,
                  parse_density_map(reader, context, word, density_.pattern.kind == PatternKind::average));
  } else {
    return false;
  }
  return true;
}

int at_least(Reader& reader, std::string_view what, int least) {
  const Token& at = reader.peek();
  const int value = integer(reader, what);
  if (value < least) reader.fail(at, "'" + std::string(what) + "' must be at least " + std::to_string(least));
  return value;
}

void parse_samples(Reader& reader, Media& media) {
  media.least_samples = media.most_samples = at_least(reader, "samples", 1);
  reader.skip_comma();
  if (!reader.at_number()) return;
  const Token& at = reader.peek();
  media.most_samples = integer(reader, "samples");
  if (media.most_samples < media.least_samples) {
    reader.fail(at, "the second number of 'samples' must not be below the first");
  }
}

/// `{ type, colour [eccentricity n] [extinction n] }`
void parse_scattering(Reader& reader, const Token& word, Media& media) {
  reader.open_block(word);
  const Token& at = reader.peek();
  int type = integer(reader, "type of 'scattering'");
  if (type < 1 || type > 5) {
    reader.warn(at, "the type of 'scattering' must be from 1 to 5; 1 is taken");
    type = 1;
  }
  media.scattering_type = static_cast<Media::Scattering>(type);
  reader.skip_comma();
  media.scattering = color_or_black(reader).rgb;
  for (;;) {
    const Token& next = reader.peek();
    if (reader.accept(Keyword::eccentricity)) {
      if (media.scattering_type != Media::Scattering::henyey_greenstein) {
        reader.fail(next, "'eccentricity' is for scattering of type 5 only");
      }
      media.eccentricity = finite_number(reader, "eccentricity");
    } else if (reader.accept(Keyword::extinction)) {
      media.extinction = finite_number(reader, "extinction");
    } else {
      break;
    }
  }
  reader.close_block();
}

/// Words about how it is sampled.
bool accept_sampling(Reader& reader, Media& media) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::intervals)) {
    media.intervals = at_least(reader, "intervals", 1);
  } else if (reader.accept(Keyword::samples)) {
    parse_samples(reader, media);
  } else if (reader.accept(Keyword::method)) {
    media.method = integer(reader, "method");
    if (media.method < 1 || media.method > 3) reader.fail(word, "'method' must be 1, 2 or 3");
  } else if (reader.accept(Keyword::jitter)) {
    media.jitter = finite_number(reader, "jitter");
  } else if (reader.accept(Keyword::aa_threshold)) {
    media.aa_threshold = finite_number(reader, "aa_threshold");
    if (media.aa_threshold <= 0.0) reader.fail(word, "'aa_threshold' must be above 0");
  } else if (reader.accept(Keyword::aa_level)) {
    media.aa_level = at_least(reader, "aa_level", 1);
  } else if (reader.accept(Keyword::confidence)) {
    media.confidence = finite_number(reader, "confidence");
    if (media.confidence < 0.0 || media.confidence >= 1.0) {
      reader.fail(word, "'confidence' must be at least 0 and below 1");
    }
  } else if (reader.accept(Keyword::variance)) {
    media.variance = finite_number(reader, "variance");
  } else if (reader.accept(Keyword::ratio)) {
    media.ratio = finite_number(reader, "ratio");
  } else {
    return false;
  }
  return true;
}

bool accept_item(Reader& reader, SceneContext& context, Media& media) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::absorption)) {
    media.absorption = color_or_black(reader).rgb;
  } else if (reader.accept(Keyword::emission)) {
    media.emission = color_or_black(reader).rgb;
  } else if (reader.accept(Keyword::scattering)) {
    parse_scattering(reader, word, media);
  } else if (reader.accept(Keyword::collect)) {
    media.collects_photons = reader.optional_number(1.0) > 0.0;
  } else if (reader.accept(Keyword::density)) {
    if (media.densities.size() >= kMostDensities) reader.fail(word, "a 'media' has more than 1000 densities");
    media.densities.push_back(parse_density(reader, context, word));
  } else if (const auto transform = accept_transformation(reader)) {
    move(media, *transform);
  } else {
    return accept_sampling(reader, media);
  }
  return true;
}

/// Before version 3.5 media were sampled another way.
Media initial_media(Reader& reader) {
  Media media;
  if (language_version(reader) >= 350) return media;
  media.method = 1;
  media.intervals = 10;
  media.least_samples = media.most_samples = 1;
  return media;
}

}  // namespace

std::shared_ptr<const render::DensityMap> parse_density_map(Reader& reader, SceneContext& context, const Token& word,
                                                            bool average) {
  return parse_blend_map<Density>(reader, word, std::nullopt, average,
                                  [&] { return parse_density_contents(reader, context); });
}

Density parse_density_contents(Reader& reader, SceneContext& context) {
  Density density;
  if (const auto declared = reader.accept_declared<Density>()) density = *declared;
  DensityOwner owner(density);
  parse_pattern(reader, context, owner);
  return density;
}

Density parse_density(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  Density density = parse_density_contents(reader, context);
  reader.close_block();
  return density;
}

Media parse_media(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  Media media;
  if (const auto declared = reader.accept_declared<Media>()) {
    media = *declared;
  } else {
    media = initial_media(reader);
  }
  while (accept_item(reader, context, media)) {
  }
  reader.close_block();
  media.unrendered = {};
  media.unrendered.add(feature_use(render::Feature::media, word));
  return media;
}

}  // namespace firstlight::parser
