// Rings about several points: ripples, and waves, whose rings are of different width.

#include "render/math/noise.h"
#include "render/texture/patterns.h"
#include "render/texture/wave.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {
namespace {

struct Source {
  Vec3 place;
  double frequency = 1.0;
};

/// At random places on the unit sphere; of waves, with random frequencies. The numbers are POV-Ray 3.7's.
std::vector<Source> sources(int count, bool differ) {
  std::vector<Source> result;
  std::uint32_t random = static_cast<std::uint32_t>(-560851967);
  for (int i = 0; i < count; ++i) {
    Source source;
    source.place = dnoise(Vec3(i, 0.0, 0.0)).normalized();
    random = random * 1812433253u + 12345u;
    if (differ) source.frequency = static_cast<double>(random >> 16 & 0x7fffu) * 0.000030518509476 + 0.01;
    result.push_back(source);
  }
  return result;
}

/// Frequency and phase say how far rings are apart; they then shape the value once more, as they do all values.
class Rings final : public Pattern {
 public:
  Rings(const PatternRequest& request, bool differ)
      : sources_(sources(request.world.number_of_waves, differ)), wave_(request.wave), differ_(differ) {}

  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    for (std::size_t i = 0; i < points.size; ++i) {
      double sum = 0.0;
      for (const Source& source : sources_) {
        sum += sine_wave(phase(distance(at.vector(i) - source.place), source, wave_)) / source.frequency;
      }
      const double mean = sum / static_cast<double>(sources_.size());
      values[i] = differ_ ? 0.2 * (2.5 + mean) : 0.5 * (1.0 + mean);
    }
  }
  bool has_tilt() const override { return true; }
  void tilt(const Tilting& tilting, const Columns3<double>& at, const SurfacePoints& points,
            Columns3<double>& normals) const override {
    const auto count = static_cast<double>(sources_.size());
    for (std::size_t i = 0; i < points.size; ++i) {
      Vec3 normal = normals.vector(i);
      for (const Source& source : sources_) {
        const Vec3 way = at.vector(i) - source.place;
        const double length = distance(way);
        const double height = sine_wave(phase(length, source, tilting.wave)) * tilting.amount / source.frequency;
        normal += way * (height / (length * count));
      }
      normals.set(i, normal);
    }
  }

 private:
  static double distance(const Vec3& way) {
    const double length = way.length();
    return length == 0.0 ? 1.0 : length;
  }
  static double phase(double distance, const Source& source, const Wave& wave) {
    const double frequency = static_cast<float>(wave.frequency);
    return distance * frequency * source.frequency + static_cast<double>(static_cast<float>(wave.phase));
  }

  std::vector<Source> sources_;
  Wave wave_;
  bool differ_;
};

}  // namespace

PatternPtr pattern::make_ripples(const PatternRequest& request) { return std::make_shared<Rings>(request, false); }
PatternPtr pattern::make_waves(const PatternRequest& request) { return std::make_shared<Rings>(request, true); }

}  // namespace firstlight::render
