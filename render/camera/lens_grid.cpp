#include "render/camera/lens_grid.h"

#include "render/lanes/math.h"
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

double rounded(double x, double steps_of_one) { return std::round(x * steps_of_one) / steps_of_one; }

/// A lens of hexagons: points of a triangular lattice, ring by ring as they are taken, in steps of it.
struct Hexagons {
  struct Step {
    int x;
    int y;
  };
  int rows;  ///< of the lattice, along the radius of the lens
  std::span<const Step> steps;

  int size() const { return static_cast<int>(steps.size()); }
  double width() const { return 0.5 / (rows * std::numbers::sqrt3); }  ///< of a step
  double height() const { return 0.5 / rows; }
  // Points and moves as POV-Ray rounds them: points lie on borders of the squares that further points keep to, and some
  // moves bring rays exactly to the middle of the lens, where a scene may have a border too.
  double most_jitter() const { return rounded(width(), width() < 0.1 ? 1e7 : 1e6); }
  std::vector<LensPoint> points() const {
    constexpr double kSixDecimals = 1e6;
    std::vector<LensPoint> points;
    for (const auto& [x, y] : steps) {
      points.push_back({rounded(x * width(), kSixDecimals), rounded(y * height(), kSixDecimals)});
    }
    return points;
  }
};

// The order is POV-Ray's: each portion that is traced together is spread over the lens.
constexpr std::array<Hexagons::Step, 7> kSteps2{{{-2, 0}, {0, 0}, {2, 0}, {-1, 1}, {-1, -1}, {1, 1}, {1, -1}}};
constexpr std::array<Hexagons::Step, 19> kSteps3{{{-2, 2},
                                                  {-2, -2},
                                                  {2, 2},
                                                  {2, -2},
                                                  {4, 0},
                                                  {-4, 0},
                                                  {0, 0},
                                                  {0, 2},
                                                  {0, -2},
                                                  {-3, 1},
                                                  {-3, -1},
                                                  {3, 1},
                                                  {3, -1},
                                                  {-1, 1},
                                                  {-1, -1},
                                                  {1, 1},
                                                  {1, -1},
                                                  {-2, 0},
                                                  {2, 0}}};
constexpr std::array<Hexagons::Step, 37> kSteps4{
    {{0, 0},   {-3, 3}, {3, -3},  {-3, -3}, {3, 3},   {-6, 0},  {6, 0},  {-2, 2}, {2, -2},  {-2, -2},
     {2, 2},   {-4, 0}, {4, 0},   {-1, 1},  {1, -1},  {-1, -1}, {1, 1},  {-2, 0}, {2, 0},   {-5, 1},
     {-5, -1}, {5, 1},  {5, -1},  {-4, 2},  {-4, -2}, {4, 2},   {4, -2}, {-1, 3}, {-1, -3}, {1, 3},
     {1, -3},  {-3, 1}, {-3, -1}, {3, 1},   {3, -1},  {0, 2},   {0, -2}}};
const std::array<Hexagons, 3> kHexagons{{{4, kSteps4}, {3, kSteps3}, {2, kSteps2}}};

/// The points that a round lens begins with: the largest hexagon that is not too large, or a square.
LensGrid begin_of_round_lens(int samples) {
  const double usual_jitter = 0.5 / std::sqrt(static_cast<double>(samples));
  for (const Hexagons& hexagons : kHexagons) {
    if (samples < hexagons.size()) continue;
    return {hexagons.points(), samples == hexagons.size() ? hexagons.most_jitter() : usual_jitter};
  }
  LensGrid square{{{-0.25, 0.25}, {0.25, 0.25}, {-0.25, -0.25}, {0.25, -0.25}}, usual_jitter};
  if (samples < 4) square.points.resize(static_cast<std::size_t>(samples));
  return square;
}

LensPoint point_of_disc(std::uint64_t index) {
  const double radius = std::sqrt(halton(index, 2) * (kRadius * kRadius));
  const double angle = halton(index, 3) * (2.0 * std::numbers::pi);
  return {radius * steady::cosine(angle), radius * steady::sine(angle)};
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
  const auto count = static_cast<std::size_t>(samples);
  LensGrid grid = begin_of_round_lens(samples);
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
  constexpr double kMostTries = 1 << 22;
  const double patience = std::min(static_cast<double>(samples) * samples, kMostTries);
  LensGrid grid{{}, 0.5 / std::sqrt(static_cast<double>(samples))};
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
