#include "render/surface/sky.h"

#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

/// The light that the layers above let through. Before 3.7: rgb, filter and transmit are those of all layers
/// multiplied.
struct Above {
  Rgb passed{1.0f, 1.0f, 1.0f};
  FilteredColor product{Rgb(1.0f), 1.0f, 1.0f};
  double share = 1.0;
};

Rgb layer_light(const FilteredColor& color, const Above& above) {
  return color.rgb * (1.0f - color.filter - color.transmit) * above.passed;
}

Rgb old_layer_light(const FilteredColor& color, Above& above) {
  const double opacity = 1.0 - static_cast<double>(color.filter) - static_cast<double>(color.transmit);
  const Rgb light = color.rgb * static_cast<float>(above.share * opacity);
  above.product = {above.product.rgb * color.rgb, above.product.filter * color.filter,
                   above.product.transmit * color.transmit};
  above.share = std::abs(static_cast<double>(above.product.filter)) + std::abs(static_cast<double>(above.product.transmit));
  return light;
}

}  // namespace

Sky::Sky(const Scene& scene, const PatternWorld& world)
    : background_(scene.settings.background),
      sphere_(scene.atmosphere.sky_sphere),
      old_filters_(scene.settings.language_version < 370) {
  if (!sphere_) return;
  for (auto pigment = sphere_->pigments.rbegin(); pigment != sphere_->pigments.rend(); ++pigment) {
    pigments_.emplace_back(*pigment, world);
  }
}

void Sky::colors(const Columns3<double>& directions, std::size_t count, Columns3<float>& colors) const {
  if (pigments_.empty()) {
    for (std::size_t i = 0; i < count; ++i) colors.set(i, background_);
    return;
  }
  const auto points = std::make_unique_for_overwrite<SurfacePoints>();
  const auto found = std::make_unique_for_overwrite<ColorColumns>();
  points->size = count;
  points->on_surface = false;
  for (std::size_t i = 0; i < count; ++i) {
    points->at.set(i, sphere_->placement.inverse_point(directions.vector(i)));
    points->uv.set(i, Vec2(0.0));
  }
  std::array<Above, kRaysAtOnce> above{};
  for (std::size_t i = 0; i < count; ++i) colors.set(i, Rgb(0.0f));
  for (const CompiledPigment& pigment : pigments_) {
    pigment.colors(*points, *found);
    for (std::size_t i = 0; i < count; ++i) {
      const FilteredColor color = found->color(i);
      if (old_filters_) {
        colors.set(i, colors.vector(i) + old_layer_light(color, above[i]));
      } else {
        colors.set(i, colors.vector(i) + layer_light(color, above[i]) * sphere_->emission);
        above[i].passed *= color.passed();
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Rgb sky = colors.vector(i);
    colors.set(i, old_filters_ ? sky * sphere_->emission + background_ * above[i].product.passed()
                               : sky + background_ * above[i].passed);
  }
}

}  // namespace firstlight::render
