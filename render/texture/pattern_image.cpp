// Pictures as patterns: their brightness as a value, and as bumps.

#include "render/texture/image_map.h"
#include "render/texture/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

float brightness(const FilteredColor& color) {
  return static_cast<float>(0.297 * static_cast<double>(color.rgb.x) + 0.589 * static_cast<double>(color.rgb.y) +
                            0.114 * static_cast<double>(color.rgb.z));
}

class ImagePattern final : public Pattern {
 public:
  explicit ImagePattern(const std::shared_ptr<const ImageUse>& use) : map_(use) {}

  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    for (std::size_t i = 0; i < points.size; ++i) {
      const auto place = map_.place(at.vector(i));
      values[i] = place ? std::clamp(value(*place), 0.0, 1.0) : 0.0;
    }
  }

 private:
  double value(const ImageMap::Place& place) const {
    const FilteredColor color = map_.as_stored(place).color;
    if (map_.use().part != ImageUse::Part::alpha) return static_cast<double>(brightness(color));
    return static_cast<double>(map_.has_alpha() ? color.transmit : color.rgb.x);
  }

  ImageMap map_;
};

/// The picture's heights make a triangle of the pixel and two below it, whose normal is laid over the surface's.
class BumpMap final : public Pattern {
 public:
  explicit BumpMap(const std::shared_ptr<const ImageUse>& use) : map_(use) {}

  void values(const Columns3<double>&, const SurfacePoints& points, Column<double>& values) const override {
    std::fill_n(values.at.begin(), points.size, 0.0);
  }
  bool has_tilt() const override { return true; }
  void tilt(const Tilting& tilting, const Columns3<double>& at, const SurfacePoints& points,
            Columns3<double>& normals) const override {
    for (std::size_t i = 0; i < points.size; ++i) {
      const auto place = map_.place(at.vector(i));
      if (place) normals.set(i, tilted(normals.vector(i), slope(*place, tilting.amount)));
    }
  }

 private:
  Vec3 slope(ImageMap::Place place, double amount) const {
    const auto within = [](double coordinate, double size) {
      return coordinate < 0.0 ? coordinate + size : coordinate >= size ? coordinate - size : coordinate;
    };
    std::array<ImageMap::Sample, 3> samples;
    samples[0] = map_.as_stored(place);
    place.x = within(place.x - 1.0, map_.width());
    place.y = within(place.y + 1.0, map_.height());
    samples[1] = map_.as_stored(place);
    place.x = within(place.x + 2.0, map_.width());
    samples[2] = map_.as_stored(place);
    const bool by_index =
        map_.use().part == ImageUse::Part::index &&
        std::ranges::all_of(samples, [](const ImageMap::Sample& sample) { return sample.index != -1; });
    const auto height = [&](const ImageMap::Sample& sample) {
      return amount * (by_index ? sample.index : static_cast<double>(brightness(sample.color)));
    };
    const Vec3 here(0.0, height(samples[0]), 0.0);
    const Vec3 left(-1.0, height(samples[1]), 1.0);
    const Vec3 right(1.0, height(samples[2]), 1.0);
    return (right - left).cross(here - left).normalized();
  }

  static Vec3 tilted(const Vec3& normal, const Vec3& slope) {
    Vec3 up = normal;
    Vec3 along = up.cross(Vec3(0.0, 1.0, 0.0));
    const double length = along.length();
    if (length < kNegligible) {
      up = Vec3(0.0, std::abs(normal.y - 1.0) < kNegligible ? 1.0 : -1.0, 0.0);
      along = Vec3(1.0, 0.0, 0.0);
    } else {
      along = along * (1.0 / length);
    }
    const Vec3 across = along.cross(up).normalized();
    return along * slope.x + up * slope.y - across * slope.z;
  }

  ImageMap map_;
};

}  // namespace

PatternPtr pattern::make_image_pattern(const PatternRequest& request) {
  return std::make_shared<ImagePattern>(request.get<ImageParameters>().image);
}

PatternPtr pattern::make_bump_map(const PatternRequest& request) {
  return std::make_shared<BumpMap>(request.get<ImageParameters>().image);
}

}  // namespace firstlight::render
