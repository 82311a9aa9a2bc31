#include "render/texture/image_store.h"

#include "render/image/image_io.h"
#include "render/math/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>

namespace firstlight::render {
namespace {

using Format = ImageSource::Format;

Format format_of(const ImageSource& source) {
  if (source.format != Format::by_name) return source.format;
  std::string extension = std::filesystem::path(source.path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::pair<std::string_view, Format> kExtensions[] = {
      {".bmp", Format::bmp},  {".exr", Format::exr},  {".gif", Format::gif},   {".hdr", Format::hdr},
      {".iff", Format::iff},  {".jpg", Format::jpeg}, {".jpeg", Format::jpeg}, {".pgm", Format::pgm},
      {".png", Format::png},  {".pot", Format::pot},  {".ppm", Format::ppm},   {".tga", Format::tga},
      {".tif", Format::tiff}, {".tiff", Format::tiff}};
  for (const auto& [name, format] : kExtensions) {
    if (extension == name) return format;
  }
  return Format::by_name;
}

/// The curve that is usual for the format. [POV-Ray 3.7 manual, "Gamma Handling"]
TransferCurve usual_curve(Format format, const FileGamma& stated, const TransferCurve& as_is) {
  switch (format) {
    case Format::png:
      if (stated.curve == FileGamma::Curve::power) return TransferCurve::of_power(stated.exponent);
      return {TransferCurve::Kind::srgb};
    case Format::exr:
    case Format::hdr:
      return {};
    case Format::iff:
    case Format::pgm:
    case Format::pot:
    case Format::ppm:
    case Format::sys:
    case Format::tiff:
      return as_is;
    default:
      return {TransferCurve::Kind::srgb};
  }
}

Transcoding transcoding(const ImageSource& source, const FileGamma& stated, const ImageGamma& gamma) {
  const Format format = format_of(source);
  switch (source.gamma) {
    case ImageSource::Gamma::none:
      return {};
    case ImageSource::Gamma::srgb:
      return {{TransferCurve::Kind::srgb}, gamma.scene};
    case ImageSource::Gamma::power:
      return {TransferCurve::of_power(source.gamma_exponent), gamma.scene};
    case ImageSource::Gamma::of_file:
      break;
  }
  if (gamma.unstated == ImageGamma::Unstated::none) return {};
  if (gamma.unstated == ImageGamma::Unstated::scene) {
    const bool says = format == Format::png && stated.curve != FileGamma::Curve::unstated;
    const bool is_light = format == Format::exr || format == Format::hdr;
    if (!says && !is_light) return {};
  }
  return {usual_curve(format, stated, gamma.scene), gamma.scene};
}

ImageKind kind_of(const ImageSource& source) {
  const Format format = format_of(source);
  ImageKind kind;
  kind.is_premultiplied = source.premultiplied.value_or(false);
  kind.blends_premultiplied = source.premultiplied.value_or(format == Format::tiff || format == Format::exr);
  kind.quantizes_grey = format == Format::png;
  return kind;
}

std::uint64_t bytes_of(const Raster& raster) {
  return std::visit([](const auto& samples) { return samples.size() * sizeof(samples[0]); }, raster.samples);
}

/// As POV-Ray cuts numbers to 16 bits: what is beyond them comes in again at the other end.
std::uint16_t to_word(double value) {
  const float scaled = static_cast<float>(value) * 65535.0f;
  if (!(std::abs(scaled) < 2e9f)) return 0;
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(scaled));
}

/// A function over the unit square, y down the rows: grey of one number, colour and alpha of five.
Raster painted(const ImageSource& source, int noise_generator, std::string& error) {
  const Function& function = *source.function;
  Raster raster;
  raster.width = static_cast<int>(source.columns);
  raster.height = static_cast<int>(source.rows);
  raster.white = 65535;
  raster.channels = function.result_count() == 1 ? 1 : 4;
  auto& samples = raster.samples.emplace<Raster::Words>();
  const std::size_t count = std::size_t{source.columns} * source.rows * static_cast<std::size_t>(raster.channels);
  samples.reserve(count);
  Evaluation evaluation;
  evaluation.noise_generator = noise_generator;
  double results[Function::kMostResults] = {};
  for (std::uint32_t y = 0; y < source.rows && !Interrupt::asked(); ++y) {
    for (std::uint32_t x = 0; x < source.columns; ++x) {
      const double at[3] = {x / (source.columns - 1.0), y / (source.rows - 1.0), 0.0};
      function.evaluate(at, results, evaluation);
      samples.push_back(to_word(results[0]));
      if (raster.channels == 1) continue;
      samples.push_back(to_word(results[1]));
      samples.push_back(to_word(results[2]));
      samples.push_back(to_word(1.0 - results[4]));
    }
    if (evaluation.steps_left == 0) error = "the loops in its function take too long";
    if (!error.empty()) return {};
  }
  samples.resize(count);  // where it was left early
  return raster;
}

std::string key_of(const ImageSource& source, const ImageGamma& gamma) {
  return fmt::format("{}|{}|{}|{}|{}|{}|{}|{}", static_cast<int>(source.format), static_cast<int>(source.gamma),
                     source.gamma_exponent, source.premultiplied ? static_cast<int>(*source.premultiplied) : 2,
                     static_cast<int>(gamma.unstated), static_cast<int>(gamma.scene.kind), gamma.scene.encoding,
                     source.path);
}

}  // namespace

bool ImageStore::take_room(std::uint64_t bytes, std::string& error) {
  if (bytes > kMostBytes - bytes_) {
    error = "the pictures of this scene take too much memory";
    return false;
  }
  bytes_ += bytes;
  return true;
}

Raster read_raster(const ImageSource& source, std::string& error) {
  Raster raster = read_raster(source.path, error, Palette::keep);
  if (error.empty() && format_of(source) == Format::pot && !join_potential(raster)) {
    error = "it is no continuous potential: that has a palette and an even width";
  }
  return raster;
}

std::shared_ptr<const Image> ImageStore::load(const ImageSource& source, const ImageGamma& gamma, int noise_generator,
                                              std::string& error) {
  if (source.function) {
    constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;
    constexpr std::uint64_t kMostWork = std::uint64_t{1} << 34;  // instructions
    const std::size_t results = source.function->result_count();
    const std::uint64_t pixels = std::uint64_t{source.columns} * source.rows;
    if (source.function->parameter_count() != 3 || (results != 1 && results != 5)) {
      error = "a function for a picture must be one of x, y and z that gives a number or a colour";
      return nullptr;
    }
    if (pixels > kMostPixels || source.function->cost() * pixels > kMostWork) {
      error = "its function is to make too many pixels";
      return nullptr;
    }
    if (!take_room(pixels * 2 * (results == 1 ? 1 : 4), error)) return nullptr;
    Raster raster = painted(source, noise_generator, error);
    if (!error.empty()) return nullptr;
    return std::make_shared<const Image>(std::move(raster), Transcoding(), ImageKind());
  }
  const std::string key = key_of(source, gamma);
  if (const auto known = images_.find(key); known != images_.end()) return known->second;
  Raster raster = read_raster(source, error);
  if (!error.empty() || !take_room(bytes_of(raster), error)) return nullptr;
  const Transcoding curve = transcoding(source, raster.gamma, gamma);
  auto image = std::make_shared<const Image>(std::move(raster), curve, kind_of(source));
  images_.emplace(key, image);
  return image;
}

}  // namespace firstlight::render
