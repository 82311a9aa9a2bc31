#include "parser/directive/interpreter.h"
#include "parser/statement/blend_map.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_function.h"
#include "parser/statement/parse_image.h"
#include "parser/statement/parse_object.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"
#include "parser/statement/pattern_owner.h"
#include "render/scene/object_probe.h"

#include <memory>
#include <string>

namespace firstlight::parser {

using render::FractalParameters;
using render::Patterning;
using render::PatternKind;
using render::SlopeParameters;
using render::Vec2;
using render::Vec3;

namespace {

/// The number of a fractal's rounds; POV-Ray cuts it to an integer.
int parse_iterations(Reader& reader) { return integer(reader, "number of iterations"); }

Vec2 parse_start(Reader& reader) {
  const Token& at = reader.peek();
  const Vec2 start = reader.vector2();
  finite(reader, at, Vec3(start.x, start.y, 0.0), "start of 'julia'");
  reader.skip_comma();
  return start;
}

FractalParameters parse_mandel(Reader& reader) {
  FractalParameters fractal;
  fractal.iterations = parse_iterations(reader);
  return fractal;
}

FractalParameters parse_julia(Reader& reader) {
  FractalParameters fractal;
  fractal.julia = true;
  fractal.start = parse_start(reader);
  fractal.iterations = parse_iterations(reader);
  return fractal;
}

/// `magnet 1|2 mandel iterations` or `magnet 1|2 julia start, iterations`
FractalParameters parse_magnet(Reader& reader) {
  FractalParameters fractal;
  fractal.exponent = 0;
  const Token& at = reader.peek();
  fractal.magnet = integer(reader, "type of 'magnet'");
  if (reader.accept(Keyword::julia)) {
    fractal.julia = true;
  } else if (!reader.accept(Keyword::mandel)) {
    reader.fail_expected("'mandel' or 'julia'");
  }
  if (fractal.magnet != 1 && fractal.magnet != 2) reader.fail(at, "the type of 'magnet' must be 1 or 2");
  if (fractal.julia) fractal.start = parse_start(reader);
  fractal.iterations = parse_iterations(reader);
  return fractal;
}

double optional(Reader& reader, std::string_view what) {
  reader.skip_comma();
  return reader.at_number() ? finite_number(reader, what) : 0.0;
}

/// The two ends of a range; none is left of equal ones.
void parse_range(Reader& reader, std::string_view what, double& low, double& high) {
  const Token& at = reader.peek();
  low = optional(reader, what);
  high = optional(reader, what);
  if (high == 0.0 || low != high) return;
  reader.warn(at, "the two ends of the " + std::string(what) + " are equal; they are ignored");
  low = high = 0.0;
}

SlopeParameters parse_slope(Reader& reader, const Token& word) {
  SlopeParameters slope;
  if (!reader.next_is(Punctuation::left_brace)) {
    slope.direction = finite_vector(reader, "direction of 'slope'");
  } else {
    reader.open_block(word);
    slope.to_point = reader.accept(Keyword::point_at);
    slope.direction = finite_vector(reader, "direction of 'slope'");
    parse_range(reader, "range of slopes", slope.low, slope.high);
    while (reader.next_is(Keyword::altitude)) {
      const Token& altitude = reader.take();
      if (slope.to_point) reader.fail(altitude, "'altitude' does not go with 'point_at'");
      slope.altitude = finite_vector(reader, "direction of 'altitude'");
      parse_range(reader, "range of altitudes", slope.low_altitude, slope.high_altitude);
    }
    reader.close_block();
  }
  if (!slope.to_point && slope.direction == Vec3(0.0) && slope.altitude == Vec3(0.0)) {
    reader.fail(word, "'slope' needs a direction");
  }
  return slope;
}

/// `object { object, transformations, list }`
void parse_object_pattern(Reader& reader, SceneContext& context, PatternOwner& owner, const Token& word) {
  reader.open_block(word);
  auto object = parse_object(reader, context);
  if (!object) reader.fail_expected("an object");
  while (const auto transform = accept_transformation(reader)) render::place(*object, *transform);
  nest(reader, word, owner.change_pattern().depth, object->depth);
  const auto held = std::make_shared<const render::Object>(std::move(*object));
  const auto probe = std::make_shared<const render::ObjectProbe>(*held);
  owner.change_pattern().parameters =
      render::ObjectParameters{held, [probe](const Vec3& point) { return probe->inside(point); }};
  owner.parse_list(reader, context, render::list_size(PatternKind::object));
  reader.close_block();
}

render::DensityFileParameters parse_density_file(Reader& reader, SceneContext& context) {
  const Token& at = reader.peek();
  render::DensityFileParameters file;
  file.path = parse_file_name(reader, {".df3"});
  std::shared_ptr<const render::DensityGrid>& grid = context.density_files[file.path];
  std::string error;
  if (!grid) grid = render::DensityGrid::read(file.path, error);
  if (!grid) reader.fail(at, error);
  file.grid = grid;
  return file;
}

void parse_pigment_pattern(Reader& reader, SceneContext& context, Patterning& pattern, const Token& word) {
  reader.open_block(word);
  render::Pigment pigment = parse_pigment_contents(reader, context, word, render::Pigment());
  reader.close_block();
  nest(reader, word, pattern.depth, pigment.pattern->depth);
  gather(pigment, pattern.unrendered);
  pattern.parameters = render::PigmentParameters{std::make_shared<const render::Pigment>(std::move(pigment))};
}

/// The words behind the pattern's name, and what the pattern sets besides.
void parse_arguments(Reader& reader, SceneContext& context, PatternOwner& owner, const Token& word, bool same_kind) {
  Patterning& pattern = owner.change_pattern();
  switch (pattern.kind) {
    case PatternKind::agate:
      pattern.parameters = render::AgateParameters();
      if (!pattern.warps.turbulence) pattern.warps.turbulence.emplace();
      return;
    case PatternKind::brick:
      if (!same_kind) pattern.parameters = render::BrickParameters();
      return;
    case PatternKind::crackle:
      pattern.parameters = render::CrackleParameters();
      return;
    case PatternKind::density_file:
      if (!reader.accept(Keyword::df3)) reader.fail_expected("'df3'");
      pattern.parameters = parse_density_file(reader, context);
      return;
    case PatternKind::facets:
      pattern.parameters = render::FacetsParameters();
      return;
    case PatternKind::function:
      pattern.parameters = render::FunctionParameters{parse_function_block(reader, word)};
      nest(reader, word, pattern.depth, std::get<render::FunctionParameters>(pattern.parameters).function->depth());
      return;
    case PatternKind::gradient:
      pattern.parameters = render::GradientParameters{finite_vector(reader, "axis of 'gradient'")};
      return;
    case PatternKind::image_pattern:
      pattern.parameters = parse_image_pattern(reader, context, word);
      return;
    case PatternKind::julia:
      pattern.parameters = parse_julia(reader);
      return;
    case PatternKind::magnet:
      pattern.parameters = parse_magnet(reader);
      return;
    case PatternKind::mandel:
      pattern.parameters = parse_mandel(reader);
      return;
    case PatternKind::object:
      return parse_object_pattern(reader, context, owner, word);
    case PatternKind::pavement:
      pattern.parameters = render::PavementParameters();
      return;
    case PatternKind::pigment_pattern:
      return parse_pigment_pattern(reader, context, pattern, word);
    case PatternKind::quilted:
      pattern.parameters = render::QuiltedParameters();
      return;
    case PatternKind::slope:
      pattern.parameters = parse_slope(reader, word);
      return;
    case PatternKind::spiral1:
    case PatternKind::spiral2:
      pattern.parameters = render::SpiralParameters{integer(reader, "number of arms", -32768, 32767)};
      return;
    case PatternKind::tiling:
      pattern.parameters = render::TilingParameters{integer(reader, "number of the tiling", -1, 255)};
      return;
    default:
      pattern.parameters = std::monostate();
  }
}

/// Some patterns begin with a wave of their own, and those whose values are places in a list with none.
void set_wave(render::Wave& wave, PatternKind kind) {
  switch (kind) {
    case PatternKind::marble:
    case PatternKind::spiral1:
    case PatternKind::spiral2:
    case PatternKind::wood:
      wave.form = render::WaveForm::triangle;
      return;
    case PatternKind::image_pattern:
    case PatternKind::quilted:
      wave.frequency = 0.0;
      return;
    default:
      if (render::is_list(kind) || render::is_image(kind)) wave.frequency = 0.0;
  }
}

PatternKind find_kind(Keyword word) {
  switch (word) {
#define PATTERN(word, entries, maker) \
  case Keyword::word:          \
    return PatternKind::word;
#include "render/texture/patterns.def"
#undef PATTERN
    default:
      return PatternKind::none;
  }
}

}  // namespace

PatternKind pattern_kind(Reader& reader, PatternPlace place, const Token& word) {
  const PatternKind kind = word.kind == TokenKind::keyword ? find_kind(word.keyword) : PatternKind::none;
  const auto need = [&](PatternPlace wanted, std::string_view name) {
    if (place != wanted) reader.fail(word, quoted(word) + " is for '" + std::string(name) + "' only");
  };
  switch (kind) {
    case PatternKind::image_map:
      need(PatternPlace::pigment, "pigment");
      return kind;
    case PatternKind::bump_map:
    case PatternKind::facets:
      need(PatternPlace::normal, "normal");
      return kind;
    case PatternKind::material_map:
    case PatternKind::tiles:
      need(PatternPlace::texture, "texture");
      return PatternKind::none;
    default:
      return kind;
  }
}

void parse_pattern_type(Reader& reader, SceneContext& context, PatternOwner& owner, const Token& word,
                        PatternKind kind) {
  Patterning& pattern = owner.change_pattern();
  const bool same_kind = pattern.kind == kind;
  pattern.kind = kind;
  pattern.unrendered = {};
  pattern.unrendered.add(feature_use(render::feature_of(kind), word));
  set_wave(pattern.wave, kind);
  if (kind == PatternKind::uv_mapping) {
    const TokenStream::Nesting nesting(reader.interpreter());
    pattern.parameters = std::monostate();
    return owner.parse_item(reader, context);
  }
  parse_arguments(reader, context, owner, word, same_kind);
  // The object pattern has its list in its block; images are read by their owner.
  if (kind != PatternKind::object && render::is_list(kind)) owner.parse_list(reader, context, render::list_size(kind));
  if (render::is_image(kind)) owner.parse_image(reader, context, word);
}

}  // namespace firstlight::parser
