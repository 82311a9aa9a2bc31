#include "render/camera/lens_grid.h"

#include "render/math/halton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>

namespace firstlight::render {
namespace {

constexpr double kRadius = 0.5;

// Digits as POV-Ray has them: the last ones shift rays by less than can be seen, but pictures are to agree.
constexpr std::array<LensPoint, 4> kSquare{{{-0.25, 0.25}, {0.25, 0.25}, {-0.25, -0.25}, {0.25, -0.25}}};
constexpr std::array<LensPoint, 7> kHexagon{{
    {-0.288675, 0.0}, {0.0, 0.0}, {0.288675, 0.0}, {-0.144338, 0.25}, {-0.144338, -0.25}, {0.144338, 0.25},
    {0.144338, -0.25},
}};
constexpr std::array<LensPoint, 19> kHexagons3{{
    {-0.192450, 0.333333}, {-0.192450, -0.333333}, {0.192450, 0.333333}, {0.192450, -0.333333}, {0.384900, 0.0},
    {-0.384900, 0.0}, {0.0, 0.0},
    {0.0, 0.333333}, {0.0, -0.333333}, {-0.288675, 0.166667}, {-0.288675, -0.166667}, {0.288675, 0.166667},
    {0.288675, -0.166667},
    {-0.096225, 0.166667}, {-0.096225, -0.166667}, {0.096225, 0.166667}, {0.096225, -0.166667}, {-0.192450, 0.0},
    {0.192450, 0.0},
}};
constexpr std::array<LensPoint, 37> kHexagons4{{
    {0.0, 0.0}, {-0.216506, 0.375}, {0.216506, -0.375}, {-0.216506, -0.375}, {0.216506, 0.375}, {-0.433013, 0.0},
    {0.433013, 0.0},
    {-0.144338, 0.25}, {0.144338, -0.25}, {-0.144338, -0.25}, {0.144338, 0.25}, {-0.288675, 0.0}, {0.288675, 0.0},
    {-0.072169, 0.125}, {0.072169, -0.125}, {-0.072169, -0.125}, {0.072169, 0.125}, {-0.144338, 0.0}, {0.144338, 0.0},
    {-0.360844, 0.125}, {-0.360844, -0.125}, {0.360844, 0.125}, {0.360844, -0.125},
    {-0.288675, 0.25}, {-0.288675, -0.25}, {0.288675, 0.25}, {0.288675, -0.25},
    {-0.072169, 0.375}, {-0.072169, -0.375}, {0.072169, 0.375}, {0.072169, -0.375},
    {-0.216506, 0.125}, {-0.216506, -0.125}, {0.216506, 0.125}, {0.216506, -0.125},
    {0.0, 0.25}, {0.0, -0.25},
}};

std::span<const LensPoint> fixed_points(int samples) {
  if (samples >= 37) return kHexagons4;
  if (samples >= 19) return kHexagons3;
  if (samples >= 7) return kHexagon;
  return kSquare;
}

double most_jitter(int samples, bool is_round) {
  if (is_round && samples == 7) return 0.144338;
  if (is_round && samples == 19) return 0.096225;
  if (is_round && samples == 37) return 0.0721688;
  return 0.5 / std::sqrt(static_cast<double>(samples));
}

LensPoint point_of_disc(std::uint64_t index) {
  const double radius = std::sqrt(halton(index, 2) * (kRadius * kRadius));
  const double angle = halton(index, 3) * (2.0 * std::numbers::pi);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// The square about the disc in small squares, an odd number along each side.
class Occupied {
 public:
  explicit Occupied(int samples)
      : side_(2 * static_cast<int>(std::ceil(std::sqrt(samples / std::numbers::pi))) + 1),
        taken_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {}

  bool at(const LensPoint& point) const { return taken_[index(point)]; }
  void take(const LensPoint& point) { taken_[index(point)] = true; }

 private:
  std::size_t index(const LensPoint& point) const {
    const auto step = [this](double x) {
      return static_cast<std::size_t>(std::min(static_cast<int>((x + kRadius) * side_), side_ - 1));
    };
    return step(point.y) * static_cast<std::size_t>(side_) + step(point.x);
  }

  int side_;
  std::vector<bool> taken_;
};

}  // namespace

LensGrid round_lens(int samples) {
  constexpr int kTries = 10;  // for each point, taken together
  const std::span<const LensPoint> fixed = fixed_points(samples);
  const auto count = static_cast<std::size_t>(samples);
  LensGrid grid{{fixed.begin(), fixed.begin() + static_cast<std::ptrdiff_t>(std::min(count, fixed.size()))},
                most_jitter(samples, true)};
  Occupied occupied(samples);
  for (const LensPoint& point : grid.points) occupied.take(point);
  std::uint64_t tried = 0;
  while (grid.points.size() < count) {
    LensPoint point = point_of_disc(tried++);
    const std::uint64_t most = count * kTries - (count - grid.points.size());
    while (occupied.at(point) && tried < most) point = point_of_disc(tried++);
    grid.points.push_back(point);
    occupied.take(point);
  }
  return grid;
}

LensGrid shaped_lens(int samples, const std::function<double(double, double)>& light) {
  // Points of dark lenses are taken at last wherever they are, the sooner the longer the search has been.
  constexpr double kMostTries = 1 << 24;
  const double patience = std::min(static_cast<double>(samples) * samples, kMostTries);
  LensGrid grid{{}, most_jitter(samples, false)};
  std::mt19937 generator;  // draws are POV-Ray's, which passes over the first
  generator.discard(1);
  for (std::uint64_t tried = 0; grid.points.size() < static_cast<std::size_t>(samples); ++tried) {
    const LensPoint point{halton(tried, 2) - kRadius, halton(tried, 3) - kRadius};
    const double weight = light(point.x + kRadius, point.y + kRadius) + static_cast<double>(tried) / patience;
    if (static_cast<double>(generator()) / 4294967296.0 <= weight) grid.points.push_back(point);
  }
  return grid;
}

}  // namespace firstlight::render
