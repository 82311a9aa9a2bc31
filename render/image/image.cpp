#include "render/image/image.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace firstlight::render {

Image::Image(Raster raster, const Transcoding& to_scene, const ImageKind& kind)
    : raster_(std::move(raster)), kind_(kind) {
  const auto white = static_cast<float>(raster_.white);
  for (const Raster::Color& color : raster_.palette) {
    const auto channel = [&](std::size_t i) { return to_scene(static_cast<float>(color[i]) / 255.0f); };
    palette_.push_back({{channel(0), channel(1), channel(2)}, 0.0f, 1.0f - static_cast<float>(color[3]) / 255.0f});
    opaque_ = opaque_ && color[3] == 255;
  }
  if (is_indexed()) {
    has_alpha_ = true;
  } else {
    has_alpha_ = raster_.channels == 2 || raster_.channels == 4;
    if (auto* const floats = std::get_if<Raster::Floats>(&raster_.samples)) {
      const auto step = static_cast<std::size_t>(raster_.channels);
      for (std::size_t i = 0; i < floats->size(); ++i) {
        if (has_alpha_ && i % step == step - 1) continue;
        float& number = (*floats)[i];
        number = to_scene(number);
        low_ = std::min(low_, number);
        high_ = std::max(high_, number);
      }
    } else {
      of_sample_.resize(static_cast<std::size_t>(raster_.white) + 1);
      for (std::size_t i = 0; i < of_sample_.size(); ++i) {
        float number = to_scene(static_cast<float>(i) / white);
        if (kind.quantizes_grey && raster_.channels == 1 && raster_.white == 255) {
          const float grey = number * 0.297f + number * 0.589f + number * 0.114f;
          number = static_cast<float>(static_cast<std::uint8_t>(grey * 255.0f)) / 255.0f;
        }
        of_sample_[i] = number;
      }
    }
    if (has_alpha_) {
      const auto step = static_cast<std::size_t>(raster_.channels);
      const std::size_t count = static_cast<std::size_t>(raster_.width) * static_cast<std::size_t>(raster_.height);
      for (std::size_t i = 0; i < count && opaque_; ++i) opaque_ = raster_.value(i * step + step - 1) >= 1.0;
    }
  }
  if (has_alpha_ && kind_.is_premultiplied && !opaque_) high_ = std::numeric_limits<float>::infinity();
}

int Image::index(int x, int y) const {
  const std::size_t sample =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(raster_.width) + static_cast<std::size_t>(x);
  if (const auto* const bytes = std::get_if<Raster::Bytes>(&raster_.samples)) return (*bytes)[sample];
  if (const auto* const words = std::get_if<Raster::Words>(&raster_.samples)) return (*words)[sample];
  return 0;
}

float Image::number(std::size_t sample) const {
  if (const auto* const bytes = std::get_if<Raster::Bytes>(&raster_.samples)) {
    return of_sample_[std::min<std::size_t>((*bytes)[sample], of_sample_.size() - 1)];
  }
  if (const auto* const words = std::get_if<Raster::Words>(&raster_.samples)) {
    return of_sample_[std::min<std::size_t>((*words)[sample], of_sample_.size() - 1)];
  }
  return std::get<Raster::Floats>(raster_.samples)[sample];
}

FilteredColor Image::color(int x, int y) const {
  const auto channels = static_cast<std::size_t>(raster_.channels);
  const std::size_t first =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(raster_.width) + static_cast<std::size_t>(x)) * channels;
  FilteredColor color;
  color.rgb = channels < 3 ? Rgb(number(first)) : Rgb(number(first), number(first + 1), number(first + 2));
  if (has_alpha_) color.transmit = 1.0f - static_cast<float>(raster_.value(first + channels - 1));
  return color;
}

}  // namespace firstlight::render
