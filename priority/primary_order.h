#pragma once

#include "priority/scheme.h"
#include "priority/slot.h"
#include "render/film/antialias.h"
#include "render/film/film.h"
#include "render/trace/primary.h"
#include "render/trace/trace_context.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace firstlight::priority {

/// The primary rays that have not begun, in the order in which they are to begin. They are made when a worker asks, so
/// they take no memory while they wait.
///
/// Order    The coarsest grid first, whatever the scheme: without it there is nothing to look at. Then tiles by the key
///          that the scheme gives their rays, equal ones from coarse to fine; of those that are equally coarse, too, a
///          worker gets its own first (Film::owner_of). Extra samples for anti-aliasing come when everything else is
///          done, as they need the finished colours.
/// Threads  All members may be called from any thread; a lock a tile.
class PrimaryOrder {
 public:
  struct Batch {
    render::PrimaryBatch rays;
    bool is_tile = false;    ///< else extra samples
    bool is_coarse = false;  ///< of the coarsest grid
  };

  PrimaryOrder(const render::TraceContext& context, render::Film& film, render::PrimaryTiles::Order order,
               const render::AntialiasSettings* antialias);

  const render::PrimaryTiles& tiles() const { return tiles_; }
  /// Sorts the tiles that have not begun; a version that was seen before changes nothing.
  void sort(const Scheme& scheme, std::uint64_t version);
  /// The slot of the most important rays that have not begun; kNoSlot: all have.
  int top() const { return top_.load(std::memory_order_relaxed); }
  /// Replaces `batch` by the next rays for `worker`. False: all have begun.
  bool next(std::size_t worker, Batch& batch);
  /// To be called when no ray waits and none is being traced. Whether there are more rays then.
  bool refill();

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
  void show_top_locked();

  render::PrimaryRays rays_;
  render::PrimaryTiles tiles_;
  std::unique_ptr<render::Antialiasing> antialias_;
  std::mutex mutex_;
  std::vector<Waiting> waiting_;  // of each worker
  std::uint64_t version_ = 0;
  std::span<const render::SamplePoint> points_;  // extra samples that have not begun
  std::atomic<int> top_ = kNoSlot;
};

}  // namespace firstlight::priority
