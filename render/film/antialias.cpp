#include "render/film/antialias.h"

#include "render/film/antialias_grid.h"
#include "render/film/antialias_halving.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>

namespace firstlight::render {
namespace {

std::uint32_t room_for(std::uint32_t pixels) {
  constexpr std::uint32_t kLeast = 1u << 18;
  constexpr std::uint32_t kMost = 1u << 22;
  return std::min(std::clamp(pixels, kLeast, kMost), std::numeric_limits<std::uint32_t>::max() - pixels);
}

void make_room(Film& film) {
  constexpr std::uint32_t kSmall = 1u << 12;  // still more than a pixel's grid needs
  for (std::uint32_t room = room_for(film.pixels()); room >= kSmall; room /= 2) {
    try {
      return film.begin_refinement(room);
    } catch (const std::bad_alloc&) {
    }
  }
  throw std::bad_alloc();
}

AntialiasSettings within_range(AntialiasSettings settings, const Film& film) {
  settings.depth = std::clamp(settings.depth, 1, 9);
  settings.threshold = std::clamp(settings.threshold, 0.0, 1.0);
  settings.jitter_amount = std::clamp(settings.jitter_amount, 0.0, 1.0);
  settings.block_size = std::min(std::max(settings.block_size, 4), std::max(film.width(), film.height()));
  return settings;
}

}  // namespace

Antialiasing::Antialiasing(const AntialiasSettings& settings, Film& film) {
  make_room(film);
  const AntialiasSettings usable = within_range(settings, film);
  if (usable.method == 1) {
    method_ = std::make_unique<GridSampling>(usable, film);
  } else {
    method_ = std::make_unique<Halving>(usable, film);
  }
}

}  // namespace firstlight::render
