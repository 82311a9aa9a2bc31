#include "parser/statement/parse_common.h"
#include "parser/statement/pattern_owner.h"

#include <array>
#include <string>

namespace firstlight::parser {

using render::Patterning;
using render::PatternKind;
using render::PavementParameters;

namespace {

/// The parameters of the pattern at hand, if they are of this kind; else an error that says what `word` is for.
template <class T>
T& parameters_for(Reader& reader, const Token& word, Patterning& pattern, std::string_view owners) {
  if (auto* found = std::get_if<T>(&pattern.parameters)) return *found;
  reader.fail(word, quoted(word) + " is for " + std::string(owners) + " only");
}

/// A number that POV-Ray keeps in eight bits.
int small_number(Reader& reader, std::string_view what) { return integer(reader, what, 0, 255); }

void parse_fractal_type(Reader& reader, const Token& word, Patterning& pattern, bool exterior) {
  if (auto* pavement = std::get_if<PavementParameters>(&pattern.parameters)) {
    (exterior ? pavement->exterior : pavement->interior) = small_number(reader, word.text);
    return;
  }
  auto& fractal =
      parameters_for<render::FractalParameters>(reader, word, pattern, "'mandel', 'julia', 'magnet' and 'pavement'");
  const int most = exterior ? 8 : 6;
  const Token& at = reader.peek();
  const int type = integer(reader, word.text);
  if (type < 0 || type > most) reader.fail(at, quoted(word) + " must be a type from 0 to " + std::to_string(most));
  (exterior ? fractal.exterior_type : fractal.interior_type) = type;
  reader.skip_comma();
  (exterior ? fractal.exterior_factor : fractal.interior_factor) = finite_number(reader, "factor");
}

void parse_exponent(Reader& reader, const Token& word, Patterning& pattern) {
  auto* fractal = std::get_if<render::FractalParameters>(&pattern.parameters);
  if (fractal == nullptr || fractal->magnet != 0) reader.fail(word, "'exponent' is for 'mandel' and 'julia' only");
  fractal->exponent = integer(reader, "exponent");
  if (fractal->exponent >= 2 && fractal->exponent <= 33) return;
  reader.warn(word, "'exponent' must be from 2 to 33; 2 is taken");
  fractal->exponent = 2;
}

void parse_metric(Reader& reader, const Token& word, Patterning& pattern) {
  if (auto* facets = std::get_if<render::FacetsParameters>(&pattern.parameters)) {
    facets->metric = finite_vector(reader, "metric").x;  // a vector in old scenes; the first component counts
  } else {
    parameters_for<render::CrackleParameters>(reader, word, pattern, "'facets' and 'crackle'").metric =
        finite_vector(reader, "metric").x;
  }
}

void parse_form(Reader& reader, const Token& word, Patterning& pattern) {
  if (auto* pavement = std::get_if<PavementParameters>(&pattern.parameters)) {
    pavement->form = small_number(reader, "form");
  } else {
    parameters_for<render::CrackleParameters>(reader, word, pattern, "'crackle' and 'pavement'").form =
        finite_vector(reader, "form");
  }
}

template <class T, double T::*member>
void parse_number(Reader& reader, const Token& word, Patterning& pattern, std::string_view owner) {
  parameters_for<T>(reader, word, pattern, owner).*member = finite_number(reader, word.text);
}

template <class T, int T::*member>
void parse_count(Reader& reader, const Token& word, Patterning& pattern, std::string_view owner) {
  parameters_for<T>(reader, word, pattern, owner).*member = small_number(reader, word.text);
}

void parse_pavement_check(Reader& reader, const Token& word, PavementParameters pavement) {
  // How many patterns there are of so many tiles. [POV-Ray 3.7 manual, "Pavement"]
  static constexpr std::array<int, 6> kTriangles = {1, 1, 1, 3, 4, 12};
  static constexpr std::array<int, 6> kSquares = {1, 1, 2, 5, 12, 35};
  static constexpr std::array<int, 6> kHexagons = {1, 1, 3, 7, 22, 0};
  const int sides = pavement.sides;
  if (sides != 3 && sides != 4 && sides != 6) reader.fail(word, "'number_of_sides' must be 3, 4 or 6");
  const auto& patterns = sides == 3 ? kTriangles : sides == 4 ? kSquares : kHexagons;
  const int most_tiles = sides == 6 ? 5 : 6;
  if (pavement.tiles < 1 || pavement.tiles > most_tiles) {
    reader.fail(word, "'number_of_tiles' must be from 1 to " + std::to_string(most_tiles));
  }
  const int most = patterns[static_cast<std::size_t>(pavement.tiles - 1)];
  if (pavement.pattern < 1 || pavement.pattern > most) {
    reader.fail(word, "'pattern' must be from 1 to " + std::to_string(most) + " for these tiles");
  }
}

}  // namespace

bool accept_pattern_parameter(Reader& reader, Patterning& pattern) {
  using namespace render;
  const Token& word = reader.peek();
  if (word.kind != TokenKind::keyword) return false;
  const auto take = [&](auto parse, auto... arguments) {
    reader.take();
    parse(reader, word, pattern, arguments...);
    return true;
  };
  switch (word.keyword) {
    case Keyword::agate_turb:
      if (!pattern.warps.turbulence) pattern.warps.turbulence.emplace();
      return take(parse_number<AgateParameters, &AgateParameters::turbulence>, "'agate'");
    case Keyword::brick_size:
      reader.take();
      parameters_for<BrickParameters>(reader, word, pattern, "'brick'").size = finite_vector(reader, "brick_size");
      return true;
    case Keyword::control0:
      return take(parse_number<QuiltedParameters, &QuiltedParameters::control0>, "'quilted'");
    case Keyword::control1:
      return take(parse_number<QuiltedParameters, &QuiltedParameters::control1>, "'quilted'");
    case Keyword::coords:
      return take(parse_number<FacetsParameters, &FacetsParameters::coords>, "'facets'");
    case Keyword::exponent:
      return take(parse_exponent);
    case Keyword::exterior:
      return take(parse_fractal_type, true);
    case Keyword::form:
      return take(parse_form);
    case Keyword::interior:
      return take(parse_fractal_type, false);
    case Keyword::interpolate:
      return take(parse_count<DensityFileParameters, &DensityFileParameters::interpolation>, "'density_file'");
    case Keyword::metric:
      return take(parse_metric);
    case Keyword::mortar:
      return take(parse_number<BrickParameters, &BrickParameters::mortar>, "'brick'");
    case Keyword::number_of_sides:
      return take(parse_count<PavementParameters, &PavementParameters::sides>, "'pavement'");
    case Keyword::number_of_tiles:
      return take(parse_count<PavementParameters, &PavementParameters::tiles>, "'pavement'");
    case Keyword::offset:
      return take(parse_number<CrackleParameters, &CrackleParameters::offset>, "'crackle'");
    case Keyword::pattern:
      return take(parse_count<PavementParameters, &PavementParameters::pattern>, "'pavement'");
    case Keyword::size:
      return take(parse_number<FacetsParameters, &FacetsParameters::size>, "'facets'");
    case Keyword::solid:
      reader.take();
      parameters_for<CrackleParameters>(reader, word, pattern, "'crackle'").solid = true;
      return true;
    default:
      return false;
  }
}

void check_pattern_parameters(Reader& reader, const Token& word, const Patterning& pattern) {
  if (const auto* pavement = std::get_if<PavementParameters>(&pattern.parameters)) {
    parse_pavement_check(reader, word, *pavement);
  }
  if (const auto* tiling = std::get_if<render::TilingParameters>(&pattern.parameters)) {
    if (tiling->type < 1 || tiling->type > 27) reader.fail(word, "the number of a 'tiling' must be from 1 to 27");
  }
}

}  // namespace firstlight::parser
