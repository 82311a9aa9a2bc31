#include "parser/statement/parse_image.h"

#include "parser/directive/interpreter.h"
#include "parser/expression/string_expression.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_function.h"

#include <memory>
#include <string_view>
#include <vector>

namespace firstlight::parser {

using render::ImageParameters;
using render::ImageSource;
using render::ImageUse;
using Format = ImageSource::Format;

namespace {

constexpr std::size_t kMostPaletteChanges = 65536;

/// The word for a format of files; then `extensions` are what their names may leave out.
bool accept_format(Reader& reader, Format& format, std::vector<std::string>& extensions) {
  struct Row {
    Keyword word;
    Format format;
    std::string_view extension;
  };
  static constexpr Row kRows[] = {
      {Keyword::bmp, Format::bmp, ".bmp"},  {Keyword::exr, Format::exr, ".exr"}, {Keyword::gif, Format::gif, ".gif"},
      {Keyword::hdr, Format::hdr, ".hdr"},  {Keyword::iff, Format::iff, ".iff"}, {Keyword::jpeg, Format::jpeg, ".jpg"},
      {Keyword::pgm, Format::pgm, ".pgm"},  {Keyword::png, Format::png, ".png"}, {Keyword::pot, Format::pot, ".pot"},
      {Keyword::ppm, Format::ppm, ".ppm"},  {Keyword::sys, Format::sys, ".bmp"}, {Keyword::tga, Format::tga, ".tga"},
      {Keyword::tiff, Format::tiff, ".tif"}};
  for (const Row& row : kRows) {
    if (!reader.accept(row.word)) continue;
    format = row.format;
    extensions = {std::string(row.extension)};
    return true;
  }
  return false;
}

/// `gamma srgb` or `gamma number`
void parse_gamma(Reader& reader, ImageSource& source) {
  if (reader.accept(Keyword::srgb)) {
    source.gamma = ImageSource::Gamma::srgb;
    return;
  }
  const Token& at = reader.peek();
  source.gamma = ImageSource::Gamma::power;
  source.gamma_exponent = finite_number(reader, "gamma");
  if (source.gamma_exponent <= 0.0) reader.fail(at, "'gamma' must be positive");
  if (source.gamma_exponent < 1.0) reader.warn(at, "'gamma' is below 1; its reciprocal may be meant");
}

void parse_function_image(Reader& reader, SceneContext& context, const Token& word, ImageSource& source) {
  constexpr int kMostPixels = 65535;
  source.columns = static_cast<std::uint32_t>(integer(reader, "width of the picture", 1, kMostPixels));
  reader.skip_comma();
  source.rows = static_cast<std::uint32_t>(integer(reader, "height of the picture", 1, kMostPixels));
  source.function = parse_function(reader, context, word);
}

/// `strict`: other numbers are mistakes; else they mean what 0 does. [POV-Ray 3.7]
ImageUse::Projection parse_map_type(Reader& reader, bool strict) {
  const Token& at = reader.peek();
  switch (integer(reader, "map_type")) {
    case 0:
      return ImageUse::Projection::planar;
    case 1:
      return ImageUse::Projection::spherical;
    case 2:
      return ImageUse::Projection::cylindrical;
    case 5:
      return ImageUse::Projection::torus;
    default:
      if (strict) reader.fail(at, "'map_type' must be 0, 1, 2 or 5");
      return ImageUse::Projection::planar;
  }
}

ImageUse::Interpolation parse_interpolation(Reader& reader, bool none_allowed) {
  const Token& at = reader.peek();
  switch (integer(reader, "interpolate")) {
    case 2:
      return ImageUse::Interpolation::bilinear;
    case 3:
      return ImageUse::Interpolation::bicubic;
    case 4:
      return ImageUse::Interpolation::normalized_distance;
    default:
      if (!none_allowed) reader.fail(at, "'interpolate' must be 2, 3 or 4");
      return ImageUse::Interpolation::none;
  }
}

render::Vec2 parse_pair(Reader& reader, std::string_view what) {
  const Token& at = reader.peek();
  const render::Vec2 pair = reader.vector2();
  finite(reader, at, render::Vec3(pair.x, pair.y, 0.0), what);
  return pair;
}

/// Accepts a word that may be said of every picture. `strict`: an image_map, which takes fewer numbers.
bool accept_placement(Reader& reader, ImageUse& image, bool strict) {
  if (reader.accept(Keyword::once)) {
    image.once = true;
  } else if (reader.accept(Keyword::map_type)) {
    image.projection = parse_map_type(reader, strict);
  } else if (reader.accept(Keyword::interpolate)) {
    image.interpolation = parse_interpolation(reader, !strict);
  } else if (reader.accept(Keyword::repeat)) {
    const Token& at = reader.peek();
    image.repeat = parse_pair(reader, "repeat");
    if (image.repeat.x <= 0.0 || image.repeat.y <= 0.0) reader.fail(at, "'repeat' of a picture must be positive");
  } else if (reader.accept(Keyword::offset)) {
    image.offset = parse_pair(reader, "offset");
  } else {
    return false;
  }
  return true;
}

bool accept_part(Reader& reader, ImageUse& image) {
  if (reader.accept(Keyword::use_color)) {
    image.part = ImageUse::Part::color;
  } else if (reader.accept(Keyword::use_index)) {
    image.part = ImageUse::Part::index;
  } else {
    return false;
  }
  return true;
}

/// `filter all n` or `filter entry, n`, and the same with `transmit`; `alpha` is an old word for `filter`.
bool accept_palette(Reader& reader, ImageUse& image) {
  const Token& word = reader.peek();
  const bool transmit = word.is(Keyword::transmit);
  if (!transmit && !word.is(Keyword::filter) && !word.is(Keyword::alpha)) return false;
  reader.take();
  if (word.is(Keyword::alpha)) reader.warn(word, "'alpha' is an old word for 'filter'");
  if (reader.accept(Keyword::all)) {
    (transmit ? image.transmit_all : image.filter_all) = finite_number(reader, word.text);
    (transmit ? image.transmits : image.filters).clear();
    return true;
  }
  const Token& at = reader.peek();
  ImageUse::PaletteChange change;
  change.entry = static_cast<int>(finite_number(reader, "entry of the palette") + 0.01);
  const auto entries = static_cast<int>(image.source.image->palette().size());
  if (entries == 0) reader.fail(at, quoted(word) + " of an entry is for pictures with a palette only");
  if (change.entry < 0 || change.entry >= entries) reader.fail(at, "the palette has no entry of this number");
  reader.skip_comma();
  change.value = finite_number(reader, word.text);
  auto& changes = transmit ? image.transmits : image.filters;
  if (changes.size() >= kMostPaletteChanges) reader.fail(word, "too many changes of a palette");
  changes.push_back(change);
  return true;
}

/// The meaning of the numbers of pictures, by what the scene has said so far.
render::ImageGamma image_gamma(const LanguageState& language) {
  using Unstated = render::ImageGamma::Unstated;
  const bool is_old = language.effective_version() < 370;
  if (!language.gamma_stated()) return {is_old ? Unstated::none : Unstated::format, {}};
  render::ImageGamma gamma{is_old ? Unstated::scene : Unstated::format, {}};
  if (language.gamma() == render::WorkingGamma::srgb) gamma.scene.kind = render::TransferCurve::Kind::srgb;
  if (language.gamma() == render::WorkingGamma::power) {
    gamma.scene = render::TransferCurve::of_power(language.gamma_exponent());
  }
  return gamma;
}

/// The source with its picture read. `in_scene_numbers`: its colours are to be numbers of the scene; else they are light
/// where the scene says what they mean, and as they are where it does not.
ImageSource parse_loaded_image(Reader& reader, SceneContext& context, bool in_scene_numbers) {
  const Token& at = reader.peek();
  ImageSource source = parse_image_source(reader, context, in_scene_numbers);
  const LanguageState& language = reader.interpreter().language();
  render::ImageGamma gamma = image_gamma(language);
  if (!in_scene_numbers) gamma.scene = {};
  std::string error;
  source.image = context.images.load(source, gamma, language.noise_generator(), error);
  if (!source.image) reader.fail(at, error);
  return source;
}

ImageParameters shared(ImageUse image) { return {std::make_shared<const ImageUse>(std::move(image))}; }

}  // namespace

std::string parse_file_name(Reader& reader, const std::vector<std::string>& extensions) {
  const Token& at = reader.peek();
  return reader.interpreter().find_file(parse_path(reader.interpreter()), extensions, at.location);
}

ImageSource parse_image_source(Reader& reader, SceneContext& context, bool has_gamma) {
  ImageSource source;
  if (reader.next_is(Punctuation::less) || reader.at_expression()) {
    reader.warn(reader.peek(), "a vector before the format of a picture is ignored");
    reader.vector3();
  }
  const Token& word = reader.peek();
  if (reader.accept(Keyword::function)) {
    parse_function_image(reader, context, word, source);
    return source;
  }
  std::vector<std::string> extensions;
  if (!accept_format(reader, source.format, extensions) && !at_string(reader.interpreter())) {
    reader.fail_expected("the format and name of a picture");
  }
  source.path = parse_file_name(reader, extensions);
  for (;;) {
    if (reader.accept(Keyword::gamma)) {
      parse_gamma(reader, source);
    } else if (reader.accept(Keyword::premultiplied)) {
      source.premultiplied = static_cast<int>(finite_number(reader, "premultiplied")) != 0;
    } else {
      break;
    }
  }
  if (!has_gamma && source.gamma == ImageSource::Gamma::of_file) source.gamma = ImageSource::Gamma::none;
  return source;
}

ImageParameters parse_image_map(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  ImageUse image;
  image.source = parse_loaded_image(reader, context, true);
  while (accept_placement(reader, image, true) || accept_part(reader, image) || accept_palette(reader, image)) {
  }
  reader.close_block();
  return shared(std::move(image));
}

ImageParameters parse_image_pattern(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  ImageUse image;
  image.source = parse_loaded_image(reader, context, false);
  for (;;) {
    if (reader.accept(Keyword::use_alpha)) {
      image.part = ImageUse::Part::alpha;
    } else if (!accept_placement(reader, image, false) && !accept_part(reader, image)) {
      break;
    }
  }
  reader.close_block();
  return shared(std::move(image));
}

ImageParameters parse_bump_map(Reader& reader, SceneContext& context, const Token& word, double& amount) {
  reader.open_block(word);
  ImageUse image;
  image.source = parse_loaded_image(reader, context, false);
  for (;;) {
    if (reader.accept(Keyword::bump_size)) {
      amount = finite_number(reader, "bump_size");
    } else if (!accept_placement(reader, image, false) && !accept_part(reader, image)) {
      break;
    }
  }
  reader.close_block();
  return shared(std::move(image));
}

ImageParameters parse_material_image(Reader& reader, SceneContext& context) {
  ImageUse image;
  image.part = ImageUse::Part::index;
  image.source = parse_loaded_image(reader, context, false);
  while (accept_placement(reader, image, false)) {
  }
  return shared(std::move(image));
}

}  // namespace firstlight::parser
