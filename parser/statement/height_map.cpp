#include "parser/statement/height_map.h"

#include "render/image/image_io.h"
#include "render/image/raster.h"
#include "render/math/interrupt.h"
#include "render/texture/image_store.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace firstlight::parser {

using render::ImageSource;
using render::Raster;

namespace {

std::uint16_t cut(float value) {
  if (!(std::abs(value) < 2e9f)) return 0;
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(value));
}

float grey_of(float red, float green, float blue) { return 0.297f * red + 0.589f * green + 0.114f * blue; }

double decoded(double value, const ImageSource& source) {
  switch (source.gamma) {
    case ImageSource::Gamma::srgb:
      return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    case ImageSource::Gamma::power:
      return std::pow(value, source.gamma_exponent);
    default:
      return value;
  }
}

/// The height that a pixel stands for.
class Pixels {
 public:
  Pixels(const Raster& raster, const ImageSource& source) : raster_(raster), source_(source) {}

  std::uint16_t height(std::size_t pixel) const {
    const std::size_t first = pixel * static_cast<std::size_t>(raster_.channels);
    if (!raster_.palette.empty()) {
      return static_cast<std::uint16_t>(std::lround(raster_.value(first) * raster_.white) * 256);
    }
    if (raster_.channels < 3) return cut(value(first) * 65535.0f);
    if (raster_.white > 255 || std::holds_alternative<Raster::Floats>(raster_.samples)) {
      return cut(grey_of(value(first), value(first + 1), value(first + 2)) * 65535.0f);
    }
    return cut(static_cast<float>((value(first) * 256.0 + value(first + 1)) * 255.0));
  }

 private:
  float value(std::size_t sample) const { return static_cast<float>(decoded(raster_.value(sample), source_)); }

  const Raster& raster_;
  const ImageSource& source_;
};

/// A function over the unit square. Its numbers are kept in 16 bits.
void evaluate_heights(const ImageSource& source, int noise_generator, render::HeightFieldParameters& field) {
  render::Evaluation evaluation;
  evaluation.noise_generator = noise_generator;
  double results[render::Function::kMostResults] = {};
  const auto word = [](double value) {
    return static_cast<float>(cut(static_cast<float>(value) * 65535.0f)) / 65535.0f;
  };
  const double width = source.columns - 1.0;
  const double height = source.rows - 1.0;
  for (std::uint32_t row = source.rows; row-- > 0 && !render::Interrupt::asked();) {
    for (std::uint32_t column = 0; column < source.columns; ++column) {
      const double at[3] = {column / width, row / height, 0.0};
      source.function->evaluate(at, results, evaluation);
      const float grey = source.function->result_count() == 1
                             ? word(results[0])
                             : grey_of(word(results[0]), word(results[1]), word(results[2]));
      field.heights.push_back(cut(grey * 65535.0f));
    }
  }
  field.heights.resize(std::size_t{source.columns} * source.rows);
}

}  // namespace

void read_heights(const ImageSource& source, int noise_generator, render::HeightFieldParameters& field,
                  std::string& error) {
  if (source.function) {
    field.columns = static_cast<int>(source.columns);
    field.rows = static_cast<int>(source.rows);
    if (std::int64_t{field.columns} * field.rows > render::kMostPixels) {
      error = "it has too many rows and columns";
      return;
    }
    if (field.columns >= 2 && field.rows >= 2) evaluate_heights(source, noise_generator, field);
  } else {
    const Raster raster = render::read_raster(source, error);
    if (!error.empty()) return;
    field.columns = raster.width;
    field.rows = raster.height;
    const Pixels pixels(raster, source);
    for (int row = raster.height; row-- > 0;) {
      for (int column = 0; column < raster.width; ++column) {
        field.heights.push_back(pixels.height(static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.width) +
                                              static_cast<std::size_t>(column)));
      }
    }
  }
}

}  // namespace firstlight::parser
