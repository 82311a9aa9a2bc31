#include "parser/statement/height_map.h"

#include "render/image/image_io.h"
#include "render/image/raster.h"
#include "render/math/interrupt.h"
#include "render/texture/image_store.h"

#include <algorithm>
#include <array>
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

/// A function over the unit square, some columns of a row at a time. Its numbers are kept in 16 bits.
void evaluate_heights(const ImageSource& source, int noise_generator, render::HeightFieldParameters& field) {
  constexpr std::size_t kAtOnce = 64;
  using Row = std::array<double, kAtOnce>;
  std::array<Row, 3> places{};
  std::array<Row, render::Function::kMostResults> found;
  const double* const at[3] = {places[0].data(), places[1].data(), places[2].data()};
  double* results[render::Function::kMostResults];
  for (std::size_t r = 0; r < found.size(); ++r) results[r] = found[r].data();
  render::Evaluation evaluation;
  evaluation.noise_generator = noise_generator;
  const auto word = [](double value) {
    return static_cast<float>(cut(static_cast<float>(value) * 65535.0f)) / 65535.0f;
  };
  const double width = source.columns - 1.0;
  const double height = source.rows - 1.0;
  for (std::uint32_t row = source.rows; row-- > 0 && !render::Interrupt::asked();) {
    places[1].fill(row / height);
    for (std::size_t first = 0; first < source.columns; first += kAtOnce) {
      const std::size_t count = std::min(kAtOnce, source.columns - first);
      for (std::size_t i = 0; i < count; ++i) places[0][i] = static_cast<double>(first + i) / width;
      const std::uint64_t steps = evaluation.steps_left / kAtOnce;  // for each of them
      const std::uint64_t others = evaluation.steps_left - steps * count;
      evaluation.steps_left = steps;
      source.function->evaluate_many(at, results, count, evaluation);
      evaluation.steps_left = others + evaluation.steps_left * count;
      for (std::size_t i = 0; i < count; ++i) {
        const float grey = source.function->result_count() == 1
                               ? word(found[0][i])
                               : grey_of(word(found[0][i]), word(found[1][i]), word(found[2][i]));
        field.heights.push_back(cut(grey * 65535.0f));
      }
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
