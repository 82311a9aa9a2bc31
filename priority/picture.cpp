#include "priority/picture.h"

namespace firstlight::priority {
namespace {

constexpr double kMiddleOfPixel = 0.5;

std::optional<render::BlurSettings> settings_of(const render::FocalBlur* blur) {
  if (blur == nullptr) return std::nullopt;
  return render::BlurSettings{blur->samples, blur->min_samples, blur->confidence, blur->variance,
                              /*is_round=*/blur->bokeh == nullptr};
}

}  // namespace

Picture::Picture(const render::TraceContext& context, render::Film& film, render::PrimaryTiles::Order order,
                 const render::AntialiasSettings* antialias)
    : rays_(context.scene, context.media, {context.camera(), film.width(), film.height()}), sink_(film) {
  const double offset = antialias != nullptr ? render::base_offset(*antialias) : kMiddleOfPixel;
  tiles_.emplace(rays_, film, render::PrimaryTiles(film.width(), film.height(), offset, order));
  passes_.push_back({&*tiles_, &sink_});
  const std::optional<render::BlurSettings> blur = settings_of(rays_.blur());
  if (!blur && antialias == nullptr) return;
  places_.emplace(film, blur);
  if (blur) {
    blur_.emplace(*places_, offset, /*is_last=*/antialias == nullptr);
    blur_rounds_.emplace(rays_, *blur_);
    passes_.push_back({&*blur_rounds_, &sink_});
  }
  if (antialias != nullptr) {
    antialiasing_.emplace(*antialias, film, *places_);
    antialias_rounds_.emplace(rays_, *antialiasing_);
    passes_.push_back({&*antialias_rounds_, &sink_});
  }
}

}  // namespace firstlight::priority
