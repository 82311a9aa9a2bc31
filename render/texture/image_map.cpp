#include "render/texture/image_map.h"

#include "render/lanes/math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace firstlight::render {
namespace {

/// A place that lies exactly between two pixels belongs to the further one. [POV-Ray 3.7]
constexpr double kBorder = 1e-10;
constexpr double kNoAlpha = 1e-10;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Into [0, period).
double wrapped(double value, double period) {
  double rest = std::fmod(value, period);
  if (rest < 0.0) rest += period;
  return rest < period ? rest : 0.0;
}

/// Part of a turn from the x axis towards z.
double turn_about_y(double x, double z, double length) {
  if (z == 0.0) return x > 0.0 ? 0.0 : 0.5;
  const double angle = steady::arc_cosine(x / length);
  return (z < 0.0 ? kTurn - angle : angle) / kTurn;
}

/// Weights of four neighbours, the second and third of which the place lies between. Keys' cubic convolution.
std::array<double, 4> cubic_weights(double place) {
  const double p = place - std::trunc(place);
  const double q = 1.0 - p;
  return {-0.5 * p * q * q, 0.5 * q * (q * (3.0 * p + 1.0) + 1.0), 0.5 * p * (p * (3.0 * q + 1.0) + 1.0),
          -0.5 * q * p * p};
}

/// Weights of the pixels right below, left below, right above and left above.
std::array<double, 4> corner_weights(ImageUse::Interpolation interpolation, double p, double q) {
  if (interpolation == ImageUse::Interpolation::bilinear) {
    return {p * q, (1.0 - p) * q, p * (1.0 - q), (1.0 - p) * (1.0 - q)};
  }
  const auto nearness = [](double a, double b) { return 1.0 / (a * a + b * b); };
  std::array<double, 4> weights = {nearness(1.0 - p, 1.0 - q), nearness(p, 1.0 - q), nearness(1.0 - p, q),
                                   nearness(p, q)};
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// A weighted sum of pixels, in double so that weights that add up to 1 do not make white more than it is.
struct Sum {
  std::array<double, 5> color{};
  double index = 0.0;

  void add(const ImageMap::Sample& pixel, double weight) {
    const FilteredColor& c = pixel.color;
    const std::array<float, 5> numbers = {c.rgb.x, c.rgb.y, c.rgb.z, c.filter, c.transmit};
    for (std::size_t i = 0; i < 5; ++i) color[i] += static_cast<double>(numbers[i]) * weight;
    index += pixel.index * weight;
  }
  ImageMap::Sample sample() const {
    const auto number = [this](std::size_t i) { return static_cast<float>(color[i]); };
    return {{{number(0), number(1), number(2)}, number(3), number(4)}, static_cast<int>(index)};
  }
};

}  // namespace

ImageMap::ImageMap(std::shared_ptr<const ImageUse> use) : use_(std::move(use)), image_(use_->source.image) {
  changes_opacity_ = use_->filter_all || use_->transmit_all || !use_->filters.empty() || !use_->transmits.empty();
  if (!image_) return;
  width_ = image_->width();
  height_ = image_->height();
  period_x_ = static_cast<float>(width_ * use_->repeat.x);
  period_y_ = static_cast<float>(height_ * use_->repeat.y);
  has_alpha_ = image_->has_alpha() || (image_->is_indexed() && changes_opacity_);
  palette_ = image_->palette();
  for (FilteredColor& color : palette_) {
    if (use_->filter_all) color.filter = static_cast<float>(*use_->filter_all);
    if (use_->transmit_all) color.transmit = static_cast<float>(*use_->transmit_all);
  }
  const auto change = [this](const std::vector<ImageUse::PaletteChange>& changes, float FilteredColor::*part) {
    for (const ImageUse::PaletteChange& change : changes) {
      const auto entry = static_cast<std::size_t>(change.entry);
      if (entry < palette_.size()) palette_[entry].*part = static_cast<float>(change.value);
    }
  };
  change(use_->filters, &FilteredColor::filter);
  change(use_->transmits, &FilteredColor::transmit);
}

bool ImageMap::lets_light_through() const {
  if (use_->once || changes_opacity_ || !image_) return true;
  return !image_->is_opaque();
}

bool lets_light_through(const std::shared_ptr<const ImageUse>& use) {
  return !use || ImageMap(use).lets_light_through();
}

std::optional<ImageMap::Place> ImageMap::place(const Vec3& point) const {
  if (!image_) return std::nullopt;
  const auto is_beside = [this](double coordinate) { return use_->once && (coordinate < 0.0 || coordinate > 1.0); };
  Place place;
  switch (use_->projection) {
    case ImageUse::Projection::planar:
      if (is_beside(point.x) || is_beside(point.y)) return std::nullopt;
      place = {std::fmod(point.x * period_x_, period_x_), std::fmod(point.y * period_y_, period_y_)};
      break;
    case ImageUse::Projection::spherical: {
      const double length = std::sqrt(point.x * point.x + point.y * point.y + point.z * point.z);
      if (length == 0.0) return std::nullopt;
      const Vec3 unit(point.x / length, point.y / length, point.z / length);
      const double from_axis = std::sqrt(unit.x * unit.x + unit.z * unit.z);
      const double turn = from_axis == 0.0 ? 0.0 : turn_about_y(unit.x, unit.z, from_axis);
      place = {turn * period_x_, (0.5 + steady::arc_sine(unit.y) / std::numbers::pi) * period_y_};
      break;
    }
    case ImageUse::Projection::cylindrical: {
      if (is_beside(point.y)) return std::nullopt;
      const double length = std::sqrt(point.x * point.x + point.y * point.y + point.z * point.z);
      if (length == 0.0) return std::nullopt;
      const double x = point.x / length, z = point.z / length;
      const double from_axis = std::sqrt(x * x + z * z);
      if (from_axis == 0.0) return std::nullopt;
      place = {turn_about_y(x, z, from_axis) * period_x_, std::fmod(point.y * period_y_, period_y_)};
      break;
    }
    case ImageUse::Projection::torus: {
      // About a circle of radius 1.
      const double from_axis = std::sqrt(point.x * point.x + point.z * point.z);
      if (from_axis == 0.0) return std::nullopt;
      const double x = from_axis - 1.0;
      double angle = steady::arc_cosine(-x / std::sqrt(x * x + point.y * point.y));
      if (point.y > 0.0) angle = kTurn - angle;
      place = {turn_about_y(point.x, point.z, from_axis) * period_x_, angle / kTurn * period_y_};
      break;
    }
  }
  place.x += use_->offset.x * -width_ + kBorder;
  place.y += use_->offset.y * -height_ + kBorder;
  if (use_->once && (place.x >= width_ || place.y >= height_ || place.x < 0.0 || place.y < 0.0)) return std::nullopt;
  // Rows count from the top, y from the bottom.
  return Place{wrapped(place.x, width_), wrapped(-place.y, height_)};
}

ImageMap::Sample ImageMap::as_stored(const Place& place) const {
  return sample(place, image_ && image_->kind().blends_premultiplied);
}

ImageMap::Sample ImageMap::pixel(double x, double y, bool premultiplied) const {
  const auto whole = [this](double coordinate, int size) {
    if (use_->once) return static_cast<int>(std::clamp(coordinate, 0.0, static_cast<double>(size - 1)));
    return static_cast<int>(wrapped(coordinate, size));
  };
  const int column = whole(x, width_);
  const int row = whole(y, height_);
  Sample sample;
  if (image_->is_indexed()) {
    sample.index = image_->index(column, row);
    sample.color = palette_[static_cast<std::size_t>(sample.index)];
  } else {
    sample.color = image_->color(column, row);
  }
  const bool is_multiplied = image_->kind().is_premultiplied;
  if (has_alpha_ && premultiplied != is_multiplied) {
    const float alpha = 1.0f - sample.color.transmit;
    if (premultiplied) {
      sample.color.rgb *= alpha;
    } else if (alpha != 0.0f) {
      sample.color.rgb /= alpha;
    }
  }
  if (!image_->is_indexed()) {
    sample.color.filter += static_cast<float>(use_->filter_all.value_or(0.0));
    sample.color.transmit += static_cast<float>(use_->transmit_all.value_or(0.0));
  }
  return sample;
}

ImageMap::Sample ImageMap::blended(const Place& place, bool premultiplied) const {
  const double x = place.x + 0.5, y = place.y + 0.5;
  const double column = std::trunc(x), row = std::trunc(y);
  Sum sum;
  if (use_->interpolation == ImageUse::Interpolation::bicubic) {
    const std::array<double, 4> across = cubic_weights(x);
    const std::array<double, 4> down = cubic_weights(y);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        sum.add(pixel(column + static_cast<double>(i) - 2.0, row + static_cast<double>(j) - 2.0, premultiplied),
                across[i] * down[j]);
      }
    }
    return sum.sample();
  }
  const std::array<double, 4> weights = corner_weights(use_->interpolation, x - column, y - row);
  sum.add(pixel(column, row, premultiplied), weights[0]);
  sum.add(pixel(column - 1.0, row, premultiplied), weights[1]);
  sum.add(pixel(column, row - 1.0, premultiplied), weights[2]);
  sum.add(pixel(column - 1.0, row - 1.0, premultiplied), weights[3]);
  return sum.sample();
}

ImageMap::Sample ImageMap::sample(const Place& place, bool premultiplied) const {
  // Colours that are multiplied by alpha are blended so, whichever are asked for.
  const bool blends = premultiplied || image_->kind().blends_premultiplied;
  Sample sample =
      use_->interpolation == ImageUse::Interpolation::none ? pixel(place.x, place.y, blends) : blended(place, blends);
  if (blends && !premultiplied) {
    const float alpha = 1.0f - sample.color.transmit;
    if (static_cast<double>(alpha) > kNoAlpha) sample.color.rgb /= alpha;
  }
  return sample;
}

}  // namespace firstlight::render
