#pragma once

#include "render/film/antialias_settings.h"
#include "render/film/contrast.h"
#include "render/film/film.h"
#include "render/film/jitter.h"
#include "render/film/place_sampler.h"
#include "render/film/sample_rounds.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace firstlight::render {

/// Method 1: a grid of samples in each pixel that differs from the pixel on its left or above it, and in that other
/// one.
///
/// POV-Ray decides pixel by pixel, within a block of pixels, and compares with what the neighbours are by then: they
/// may have a grid already. Here all pixels are decided at once, as far as what they are compared with is known; the
/// rest after the next round.
class GridSampling final : public SampleRounds {
 public:
  GridSampling(const AntialiasSettings& settings, Film& film, PlaceSampler& sampler);
  std::span<const SamplePoint> next() override;

 private:
  /// Pixels from (left, top), `right` and `bottom` not included.
  struct Block {
    int left;
    int top;
    int right;
    int bottom;
  };
  struct Wanted {
    std::uint32_t pixel;
    bool sure;  ///< the pixel will have this grid; else it may
  };
  enum class Answer : std::uint8_t { no, yes, unknown };
  enum class Asked : std::uint8_t { nothing, edge, grids };

  void make_blocks(int block_size);
  void collect();
  void ask_for_edge();
  void ask_for_grids();
  /// Lets the film show the round's grids as they grow.
  void show_grids();
  void decide();
  /// Returns true when nothing is unknown. `guess`: ask for all grids that may be needed.
  bool decide(const Block& block, bool guess);
  void look_at(const Block& block);
  Answer differs(std::size_t cell, std::optional<std::uint32_t> pixel, std::size_t from) const;
  std::uint32_t pixel_at(int x, int y) const {
    return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(film_.width()) + static_cast<std::uint32_t>(x);
  }

  Film& film_;
  Contrast contrast_;
  Jitter jitter_;
  PlaceSampler& sampler_;                 ///< of the round
  std::vector<double> offsets_;           ///< of the grid's columns, and of its rows, from the middle of the pixel
  std::vector<PixelColor> edge_;          ///< just outside: the row above the picture, then the column on its left
  std::size_t edge_asked_ = 0;            ///< how many of them are traced or asked for
  std::vector<PixelColor> supersampled_;  ///< by pixel
  std::vector<bool> has_grid_;            ///< by pixel: the above is there
  std::vector<Block> blocks_;             ///< still undecided
  std::vector<Wanted> wanted_;            ///< whose grids are to be traced
  std::size_t wanted_begin_ = 0;          ///< of the round at hand
  std::size_t wanted_end_ = 0;
  int decisions_ = 0;
  Asked asked_ = Asked::nothing;
  // Both are of the block at hand, with a row above and a column on the left of it.
  std::vector<PixelColor> encoded_;
  std::vector<Answer> answers_;
};

}  // namespace firstlight::render
