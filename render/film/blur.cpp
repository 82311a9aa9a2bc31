#include "render/film/blur.h"

#include "render/math/chi_square.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace firstlight::render {
namespace {

// Round lenses are hexagons first, whose samples belong together.
constexpr std::array<int, 1> kStops2{7};
constexpr std::array<int, 3> kStops3{7, 13, 19};
constexpr std::array<int, 8> kStops4{7, 13, 19, 23, 27, 31, 35, 37};
constexpr int kUsualStep = 4;

std::span<const int> stops_of_hexagons(const BlurSettings& settings) {
  if (!settings.is_round || settings.samples < kStops2.back()) return {};
  if (settings.samples < kStops3.back()) return kStops2;
  if (settings.samples < kStops4.back()) return kStops3;
  return kStops4;
}

/// The variance of the mean of a channel.
float variance_of(float squares, float sum, double count) {
  const double mean = sum / count;
  return static_cast<float>((squares / count - mean * mean) / count);
}

}  // namespace

BlurRule::BlurRule(const BlurSettings& settings)
    : settings_(settings), thresholds_(static_cast<std::size_t>(settings.samples) + 1) {
  if (settings.samples < 2) return;
  const double scale = settings.variance / chi_square_quantile(settings.samples - 1, settings.confidence);
  for (int stop = next_stop(0);; stop = next_stop(stop)) {
    thresholds_[static_cast<std::size_t>(stop)] = scale * chi_square_quantile(stop, settings.confidence);
    if (stop == settings.samples) return;
  }
}

int BlurRule::next_stop(int count) const {
  const std::span<const int> hexagons = stops_of_hexagons(settings_);
  const auto stop = std::ranges::upper_bound(hexagons, count);
  if (stop != hexagons.end()) return *stop;
  const int begin = hexagons.empty() ? 0 : hexagons.back();
  return std::min(begin + ((count - begin) / kUsualStep + 1) * kUsualStep, settings_.samples);
}

bool BlurRule::is_enough(const PlaceSums& sums) const {
  if (sums.count >= settings_.samples) return true;
  if (sums.count < settings_.min_samples) return false;
  const double threshold = thresholds_[static_cast<std::size_t>(sums.count)];
  const auto is_near = [&](float squares, float sum) { return variance_of(squares, sum, sums.count) < threshold; };
  for (unsigned channel = 0; channel < 3; ++channel) {
    if (!is_near(sums.squares.light[channel], sums.sum.light[channel])) return false;
  }
  return is_near(sums.squares.clear, sums.sum.clear);
}

}  // namespace firstlight::render
