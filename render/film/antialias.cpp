#include "render/film/antialias.h"

#include "render/film/antialias_grid.h"
#include "render/film/antialias_halving.h"

#include <algorithm>

namespace firstlight::render {
namespace {

AntialiasSettings within_range(AntialiasSettings settings, const Film& film) {
  settings.depth = std::clamp(settings.depth, 1, 9);
  settings.threshold = std::clamp(settings.threshold, 0.0, 1.0);
  settings.jitter_amount = std::clamp(settings.jitter_amount, 0.0, 1.0);
  settings.block_size = std::min(std::max(settings.block_size, 4), std::max(film.width(), film.height()));
  return settings;
}

}  // namespace

Antialiasing::Antialiasing(const AntialiasSettings& settings, Film& film, PlaceSampler& places) : places_(places) {
  const AntialiasSettings usable = within_range(settings, film);
  if (usable.method == 1) {
    method_ = std::make_unique<GridSampling>(usable, film, places);
  } else {
    method_ = std::make_unique<Halving>(usable, film, places);
  }
}

std::span<const SamplePoint> Antialiasing::next() {
  if (const auto points = places_.more(); !points.empty()) return points;
  return method_->next();
}

}  // namespace firstlight::render
