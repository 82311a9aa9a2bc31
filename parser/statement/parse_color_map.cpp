#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"
#include "render/math/single.h"

#include <algorithm>

namespace firstlight::parser {

using render::ColorMap;
using render::ColorMapEntry;
using render::FilteredColor;

namespace {

constexpr std::size_t kMaxEntries = 256;  ///< POV-Ray's own limit

bool same(const ColorMapEntry& a, const ColorMapEntry& b) {
  return a.position == b.position && a.color.rgb == b.color.rgb && a.color.filter == b.color.filter &&
         a.color.transmit == b.color.transmit;
}

/// Positions have the precision of a float, as in POV-Ray.
double position(double value) { return render::in_single(value); }

FilteredColor color_of(const Numbers& numbers) {
  const auto part = [&](int i) { return static_cast<float>(numbers.values[i]); };
  return FilteredColor{render::Rgb(part(0), part(1), part(2)), part(3), part(4)};
}

/// Parses what follows the `[`: a position and a colour, or in old scenes two positions and two colours.
void parse_entry(Reader& reader, ColorMap& map) {
  ColorMapEntry first;
  first.position = position(finite_number(reader, "position in 'color_map'"));
  reader.skip_comma();
  if (!reader.at_number()) {
    if (!at_color(reader)) reader.fail_expected("a colour");
    first.color = reader.color();
    map.push_back(first);
    return;
  }
  const Token& at = reader.peek();
  const Numbers numbers = reader.expression();
  if (numbers.size == 5) {
    first.color = color_of(numbers);
    map.push_back(first);
    return;
  }
  if (numbers.size != 1) reader.fail(at, "expected a colour or a second position in 'color_map', found a vector");
  ColorMapEntry second;
  second.position = position(finite(reader, at, numbers.values[0], "position in 'color_map'"));
  first.color = reader.color();
  if (!reader.next_is(Keyword::color)) reader.fail_expected("'color'");
  second.color = reader.color();
  map.push_back(first);
  map.push_back(second);
}

}  // namespace

ColorMap parse_color_map(Reader& reader, const Token& word) {
  reader.open_block(word);
  if (const auto declared = reader.accept_declared<ColorMap>()) {
    reader.close_block();
    return *declared;
  }
  ColorMap map;
  while (reader.next_is(Punctuation::left_bracket)) {
    const Token& at = reader.take();
    parse_entry(reader, map);
    if (!reader.accept(Punctuation::right_bracket)) reader.fail_expected("']'");
    if (map.size() > kMaxEntries) reader.fail(at, "a 'color_map' has at most 256 entries");
  }
  if (map.empty()) reader.fail_expected("'[' and an entry of the map");
  reader.close_block();
  map.erase(std::unique(map.begin(), map.end(), same), map.end());
  return map;
}

}  // namespace firstlight::parser
