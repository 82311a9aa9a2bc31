#include "render/surface/pigment_limits.h"

namespace firstlight::render {
namespace {

/// begin + slope t.
struct Line {
  double begin = 0.0;
  double slope = 0.0;
};

/// Values of a(t) b(t) + c(t) for t in [0, 1]: at the ends, or where the parabola turns.
void include_product(Range& range, const Line& a, const Line& b, const Line& c) {
  const auto value = [&](double t) {
    return (a.begin + a.slope * t) * (b.begin + b.slope * t) + c.begin + c.slope * t;
  };
  range.include(value(0.0));
  range.include(value(1.0));
  const double square = a.slope * b.slope;
  const double turn = -(a.begin * b.slope + a.slope * b.begin + c.slope) / (2.0 * square);
  if (square != 0.0 && turn > 0.0 && turn < 1.0) range.include(value(turn));
}

}  // namespace

PigmentLimits::PigmentLimits(const Pigment& pigment, int language_version, bool quick_colors)
    : old_opacity_(language_version < 370), quick_colors_(quick_colors) {
  if (const FilteredColor* const even = even_color(pigment, quick_colors)) {
    include(*even, *even, 0.0);
  } else if (is_image(pigment.pattern->kind)) {
    include_image(*std::get<ImageParameters>(pigment.pattern->parameters).image);
  } else {
    if (pigment.pattern->pigments) {
      for (const MapEntry<Pigment>& entry : pigment.pattern->pigments->entries) include_all(entry.value);
      return;
    }
    const ColorMap& map = map_of(pigment);
    for (const ColorMapEntry& entry : map) include(entry.color, entry.color, 0.0);
    const Wave& wave = pigment.pattern->wave;  // a list's places are whole numbers, unless a wave moves them
    const bool blends = !is_list(pigment.pattern->kind) || wave.frequency != 0.0 || wave.form != WaveForm::ramp;
    for (std::size_t i = 1; blends && i < map.size(); ++i) {
      include(map[i - 1].color, map[i].color, kBlendError);
    }
  }
  if (old_opacity_) {
    for (std::size_t i = 0; i < 3; ++i) body[i] = color[i].size() * old_opacity_most_;
  }
}

bool PigmentLimits::may_turn_negative() const {
  return has_negative_color() || least_opacity_ < 0.0 || std::min({passed[0].low, passed[1].low, passed[2].low}) < 0.0;
}

bool PigmentLimits::only_takes() const {
  return std::ranges::all_of(
      passed, [](const Range& range) { return range.low >= -kBlendError && range.high <= 1.0 + kBlendError; });
}

void PigmentLimits::include_all(const Pigment& part) {
  const PigmentLimits limits(part, old_opacity_ ? 360 : 370, quick_colors_);
  is_known = is_known && limits.is_known;
  for (std::size_t i = 0; i < 3; ++i) {
    color[i].include(limits.color[i].low);
    color[i].include(limits.color[i].high);
    passed[i].include(limits.passed[i].low);
    passed[i].include(limits.passed[i].high);
    body[i] = std::max(body[i], limits.body[i]);
  }
}

/// All corners of what colours, filters and transmits can be, as if each were there with each.
void PigmentLimits::include_image(const ImageUse& use) {
  if (!use.source.image) {
    is_known = false;
    return include({}, {Rgb(1.0f), 0.0f, 0.0f}, 0.0);
  }
  const Image& image = *use.source.image;
  is_known = std::isfinite(image.high());
  Range colors, filters, transmits;
  colors.include(static_cast<double>(image.low()));
  colors.include(is_known ? static_cast<double>(image.high()) : 1.0);
  filters.include(0.0);
  transmits.include(0.0);
  if (image.has_alpha()) transmits.include(1.0);
  if (image.is_indexed()) {
    if (use.filter_all) filters.include(*use.filter_all);
    if (use.transmit_all) transmits.include(*use.transmit_all);
    for (const ImageUse::PaletteChange& change : use.filters) filters.include(change.value);
    for (const ImageUse::PaletteChange& change : use.transmits) transmits.include(change.value);
  } else {
    filters.low = filters.high = use.filter_all.value_or(0.0);
    transmits.low += use.transmit_all.value_or(0.0);
    transmits.high += use.transmit_all.value_or(0.0);
  }
  if (use.interpolation == ImageUse::Interpolation::bicubic) {
    // Its weights above 0 add up to at most 1.25^2/2 + 1/2, the others to 1 less.
    constexpr double kExcess = (1.25 * 1.25 - 1.0) / 2.0;
    for (Range* range : {&colors, &filters, &transmits}) {
      const double size = range->high - range->low;
      range->low -= kExcess * size;
      range->high += kExcess * size;
    }
    is_known = is_known && !image.kind().blends_premultiplied;
  }
  const auto corner = [&](int which) {
    const auto pick = [which](const Range& range, int bit) {
      return static_cast<float>((which & bit) != 0 ? range.high : range.low);
    };
    return FilteredColor{Rgb(pick(colors, 1)), pick(filters, 2), pick(transmits, 4)};
  };
  for (int which = 0; which < 8; ++which) include(corner(which), corner(which), kBlendError);
}

void PigmentLimits::include(const FilteredColor& from, const FilteredColor& to, double error) {
  const auto line = [](float a, float b) { return Line{a, static_cast<double>(b) - static_cast<double>(a)}; };
  const Line filter = line(from.filter, to.filter);
  const Line transmit = line(from.transmit, to.transmit);
  const Line opacity{1.0 - filter.begin - transmit.begin, -filter.slope - transmit.slope};
  const Channels first = channels_of(from.rgb);
  const Channels last = channels_of(to.rgb);
  least_opacity_ = std::min({least_opacity_, opacity.begin, opacity.begin + opacity.slope});
  for (std::size_t i = 0; i < 3; ++i) {
    const Line tint{first[i], last[i] - first[i]};
    color[i].include(first[i]);
    color[i].include(last[i]);
    Range through;
    include_product(through, filter, tint, transmit);
    passed[i].include(through.low);
    passed[i].include(through.high);
    // Before 3.7 opacity is 1 - passed of the strongest channel, whichever that is.
    old_opacity_most_ = std::max({old_opacity_most_, std::abs(1.0 - through.low), std::abs(1.0 - through.high)});
    Range own;
    include_product(own, tint, opacity, {});
    body[i] = std::max(body[i], own.size() + error * std::max(std::abs(first[i]), std::abs(last[i])));
  }
}

}  // namespace firstlight::render
