#pragma once

#include "render/film/antialias_settings.h"
#include "render/film/contrast.h"
#include "render/film/film.h"
#include "render/film/jitter.h"
#include "render/film/place_sampler.h"
#include "render/film/place_table.h"
#include "render/film/sample_rounds.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Method 2: a pixel is the mean of its corners; where they differ, the mean of its four quarters, each treated alike.
///
/// Quarters are looked at level by level over the whole picture, so that the corners they share, also with quarters of
/// other pixels, are traced once.
class Halving final : public SampleRounds {
 public:
  Halving(const AntialiasSettings& settings, Film& film, PlaceSampler& sampler);
  std::span<const SamplePoint> next() override;

 private:
  using Corners = std::array<PixelColor, 4>;  ///< upper left, upper right, lower left, lower right
  /// A square in a pixel, whose corners differ.
  struct Cell {
    std::uint32_t pixel = 0;
    std::uint16_t x = 0;  ///< of its upper left corner in the pixel, in finest steps
    std::uint16_t y = 0;
    Corners corners;
  };
  /// All cells of one size. Those before `begin` are done.
  struct Level {
    std::vector<Cell> cells;
    std::size_t begin = 0;

    std::size_t open() const { return cells.size() - begin; }
  };
  /// Samples, by their numbers in the round, in the middle of a cell's sides and in its own.
  struct Middles {
    std::uint32_t top;
    std::uint32_t left;
    std::uint32_t middle;
    std::uint32_t right;
    std::uint32_t bottom;
  };

  void ask_for_edge();
  void collect_edge();
  void look_at_pixels();
  void ask_for_middles();
  void collect_middles();
  std::size_t level_to_do() const;
  bool differ(const Corners& corners) const;
  std::uint32_t sample_at(const Cell& cell, std::uint32_t x, std::uint32_t y);

  Film& film_;
  Contrast contrast_;
  Jitter jitter_;
  PlaceSampler& sampler_;         ///< of the round
  PlaceTable places_;             ///< of the samples of the round
  std::uint32_t side_;            ///< of a pixel, in finest steps
  std::vector<PixelColor> edge_;  ///< corners on the right edge of the picture from the top, then on the lower one
  std::size_t edge_asked_ = 0;
  bool pixels_looked_at_ = false;
  std::vector<Level> levels_;     ///< from whole pixels to the smallest cells that may be quartered
  std::size_t level_ = 0;         ///< of the round at hand
  std::vector<Middles> middles_;  ///< of the cells of the round, which begin at Level::begin
};

}  // namespace firstlight::render
