#include "priority/picture.h"

namespace firstlight::priority {
namespace {

constexpr double kMiddleOfPixel = 0.5;

}  // namespace

Picture::Picture(const render::TraceContext& context, render::Film& film, render::PrimaryTiles::Order order,
                 const render::AntialiasSettings* antialias)
    : rays_(context.scene, context.media, {context.camera(), film.width(), film.height()}), sink_(film) {
  const double offset = antialias != nullptr ? render::base_offset(*antialias) : kMiddleOfPixel;
  tiles_.emplace(rays_, film, render::PrimaryTiles(film.width(), film.height(), offset, order));
  passes_.push_back({&*tiles_, &sink_});
  if (antialias == nullptr) return;
  antialiasing_.emplace(*antialias, film);
  rounds_.emplace(rays_, *antialiasing_);
  passes_.push_back({&*rounds_, &sink_});
}

}  // namespace firstlight::priority
