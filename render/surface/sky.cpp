#include "render/surface/sky.h"

#include "render/math/scratch.h"
#include "render/math/transform_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firstlight::render {

/// Light that they let through. Before 3.7: rgb, filter and transmit are those of all layers multiplied.
struct Sky::Above {
  Rgb passed{1.0f, 1.0f, 1.0f};
  FilteredColor product{Rgb(1.0f), 1.0f, 1.0f};
  double share = 1.0;
};

Rgb Sky::layer_light(const FilteredColor& color, const Above& above) {
  return color.rgb * (1.0f - color.filter - color.transmit) * above.passed;
}

Rgb Sky::old_layer_light(const FilteredColor& color, Above& above) {
  const double opacity = 1.0 - static_cast<double>(color.filter) - static_cast<double>(color.transmit);
  const Rgb light = color.rgb * static_cast<float>(above.share * opacity);
  above.product = {above.product.rgb * color.rgb, above.product.filter * color.filter,
                   above.product.transmit * color.transmit};
  above.share =
      std::abs(static_cast<double>(above.product.filter)) + std::abs(static_cast<double>(above.product.transmit));
  return light;
}

Sky::Sky(const Scene& scene, const PatternWorld& world)
    : background_(scene.settings.background),
      background_with_alpha_(scene.settings.background_with_alpha),
      sphere_(scene.atmosphere.sky_sphere),
      old_filters_(scene.settings.language_version < 370) {
  if (!sphere_) return;
  for (auto pigment = sphere_->pigments.rbegin(); pigment != sphere_->pigments.rend(); ++pigment) {
    pigments_.emplace_back(*pigment, world);
  }
}

void Sky::lay(const Columns3<double>& directions, std::size_t count, Columns3<float>& colors,
              std::span<Above> above) const {
  for (std::size_t i = 0; i < count; ++i) colors.set(i, Rgb(0.0f));
  if (pigments_.empty()) return;
  const Scratch<SurfacePoints> points;
  const Scratch<ColorColumns> found;
  points->size = count;
  points->on_surface = false;
  inverse_points(sphere_->placement, directions, 0, count, points->at);
  for (std::size_t i = 0; i < count; ++i) points->uv.set(i, Vec2(0.0));
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
}

void Sky::colors(const Columns3<double>& directions, std::size_t count, const Rgb& background,
                 Columns3<float>& colors) const {
  std::array<Above, kRaysAtOnce> above{};
  lay(directions, count, colors, above);
  for (std::size_t i = 0; i < count; ++i) {
    const Rgb sky = colors.vector(i);
    const bool is_old = old_filters_ && sphere_ != nullptr;
    colors.set(i, is_old ? sky * sphere_->emission + background * above[i].product.passed()
                         : sky + background * above[i].passed);
  }
}

void Sky::colors_with_alpha(const Columns3<double>& directions, std::size_t count, Columns3<float>& colors,
                            Column<float>& clear) const {
  if (old_filters_) {
    for (std::size_t i = 0; i < count; ++i) colors.set(i, Rgb(0.0f));
    std::fill_n(clear.at.begin(), count, 1.0f);
    return;
  }
  std::array<Above, kRaysAtOnce> above{};
  lay(directions, count, colors, above);
  for (std::size_t i = 0; i < count; ++i) {
    colors.set(i, colors.vector(i) + layer_light(background_with_alpha_, above[i]));
    clear[i] = std::min(1.0f, std::abs(grey(above[i].passed * background_with_alpha_.passed())));
  }
}

}  // namespace firstlight::render
