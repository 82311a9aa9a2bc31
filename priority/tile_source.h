#pragma once

#include "priority/root_source.h"
#include "render/film/film.h"
#include "render/trace/primary.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace firstlight::priority {

/// One primary ray for each pixel of a picture, tile by tile.
///
/// Order    The coarsest grid first, whatever the scheme: without it there is nothing to look at. Then tiles by the key
///          that the scheme gives their rays, equal ones from coarse to fine; of those that are equally coarse, too, a
///          worker gets its own first (Film::owner_of).
/// Threads  A lock a tile.
class TileSource final : public RootSource {
 public:
  /// Pre: rays and film outlive it; the film has been dealt out.
  TileSource(const render::PrimaryRays& rays, render::Film& film, render::PrimaryTiles tiles);

  int top() const override { return top_.load(std::memory_order_relaxed); }
  bool next(std::size_t worker, Roots& roots) override;
  void sort(const Scheme& scheme, std::uint64_t version) override;
  Reached lit(const Roots& roots) override;
  Extent extent() const override { return {lit_.load(std::memory_order_relaxed), tiles_.count()}; }

 private:
  struct Tile {
    std::uint32_t number;
    int stride;
    Slot slot;

    /// Whether this one has to leave before the other.
    bool precedes(const Tile& other) const { return slot != other.slot ? slot > other.slot : stride > other.stride; }
  };
  /// The tiles of one worker that have not begun, in the order of leaving.
  struct Waiting {
    std::vector<Tile> tiles;
    std::size_t begun = 0;

    const Tile* first() const { return begun < tiles.size() ? &tiles[begun] : nullptr; }
  };
  /// Where the next tile for `worker` is first; null: all have begun.
  Waiting* next_locked(std::size_t worker);
  bool take(std::size_t worker, std::uint32_t& tile);
  void show_top_locked();

  const render::PrimaryRays& rays_;
  render::Film& film_;
  const render::PrimaryTiles tiles_;
  std::mutex mutex_;
  std::vector<Waiting> waiting_;  // of each worker
  std::uint64_t version_ = 0;
  std::atomic<int> top_ = kNoSlot;
  std::atomic<std::uint32_t> lit_ = 0;
  std::atomic<std::uint32_t> coarse_lit_ = 0;
};

}  // namespace firstlight::priority
