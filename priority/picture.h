#pragma once

#include "priority/film_sink.h"
#include "priority/pass.h"
#include "priority/round_source.h"
#include "priority/tile_source.h"
#include "render/film/antialias.h"
#include "render/film/film.h"
#include "render/film/place_sampler.h"
#include "render/trace/primary.h"
#include "render/trace/trace_context.h"

#include <optional>
#include <span>
#include <vector>

namespace firstlight::priority {

/// The passes of a picture: a ray for each pixel, those of focal blur, then anti-aliasing.
class Picture {
 public:
  /// `antialias` may be null: none. Pre: all outlive it, nothing has been added to the film.
  Picture(const render::TraceContext& context, render::Film& film, render::PrimaryTiles::Order order,
          const render::AntialiasSettings* antialias);

  std::span<const Pass> passes() const { return passes_; }

 private:
  render::PrimaryRays rays_;
  FilmSink sink_;
  std::optional<render::PlaceSampler> places_;
  std::optional<render::PixelBlur> blur_;
  std::optional<render::Antialiasing> antialiasing_;
  std::optional<TileSource> tiles_;
  std::optional<RoundSource> blur_rounds_;
  std::optional<RoundSource> antialias_rounds_;
  std::vector<Pass> passes_;
};

}  // namespace firstlight::priority
