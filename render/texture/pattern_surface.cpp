// Patterns that go by how a surface lies: slope, and aoi, the angle under which it is seen.

#include "render/lanes/math.h"
#include "render/texture/patterns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

/// Into [0, 1) as a map that repeats; numbers below 0 once only. [POV-Ray 3.7]
double folded(double value) { return value < 0.0 ? 1.0 + std::fmod(value, 1.0) : std::fmod(value, 1.0); }

class Slope final : public Pattern {
 public:
  explicit Slope(const SlopeParameters& parameters) : parameters_(parameters) {
    if (parameters.to_point) return;
    const double slope = parameters.direction.length();
    const double altitude = parameters.altitude.length();
    if (slope != 0.0) parameters_.direction = parameters.direction * (1.0 / slope);
    if (altitude != 0.0) parameters_.altitude = parameters.altitude * (1.0 / altitude);
    has_altitude_ = altitude != 0.0;
    share_of_slope_ = slope / (slope + altitude);
  }

  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    for (std::size_t i = 0; i < points.size; ++i) {
      values[i] = points.on_surface ? value(at.vector(i), points.place.vector(i), points.tilted.vector(i)) : 0.0;
    }
  }

 private:
  double value(const Vec3& point, const Vec3& place, const Vec3& normal) const {
    const Vec3 direction = parameters_.to_point ? (parameters_.direction - place).normalized() : parameters_.direction;
    const double cosine = std::clamp(normal.dot(direction), -1.0, 1.0);
    const double slope =
        in_range((steady::arc_sine(cosine) / std::numbers::pi * 2.0 + 1.0) * 0.5, parameters_.low, parameters_.high);
    if (!has_altitude_) return slope == 1.0 ? slope - kNegligible : folded(slope);
    const double altitude =
        in_range(point.dot(parameters_.altitude), parameters_.low_altitude, parameters_.high_altitude);
    const double sum = share_of_slope_ * slope + (1.0 - share_of_slope_) * altitude;
    return sum - 1.0 < kNegligible && sum >= 1.0 ? sum - kNegligible : folded(sum);
  }
  static double in_range(double value, double low, double high) {
    const double range = high - low;
    return range != 0.0 ? (value - low) / range : value;
  }

  SlopeParameters parameters_;
  bool has_altitude_ = false;
  double share_of_slope_ = 1.0;
};

class AngleOfIncidence final : public Pattern {
 public:
  void values(const Columns3<double>&, const SurfacePoints& points, Column<double>& values) const override {
    for (std::size_t i = 0; i < points.size; ++i) {
      values[i] = 0.0;
      if (!points.on_surface) continue;
      const Vec3 normal = points.tilted.vector(i).normalized();
      const Vec3 direction = points.direction.vector(i).normalized();
      values[i] = steady::arc_cosine(std::clamp(normal.dot(direction), -1.0, 1.0)) / std::numbers::pi;
    }
  }
};

}  // namespace

PatternPtr pattern::make_slope(const PatternRequest& request) {
  return std::make_shared<Slope>(request.get<SlopeParameters>());
}

PatternPtr pattern::make_aoi(const PatternRequest&) { return std::make_shared<AngleOfIncidence>(); }

}  // namespace firstlight::render
