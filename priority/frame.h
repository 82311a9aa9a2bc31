#pragma once

#include "priority/driver.h"
#include "priority/ray_queue.h"
#include "render/film/film.h"
#include "render/trace/primary.h"
#include "render/trace/step.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace firstlight::priority {

/// What the workers of one picture share: the tiles still to begin, the film, and how far it all is.
/// Threads  All members may be called from any thread.
class Frame {
 public:
  Frame(const render::TraceContext& context, render::Film& film, const TraceOptions& options);

  const render::TraceContext& context() const { return context_; }
  const render::PrimaryTiles& tiles() const { return tiles_; }

  /// The number of a tile that nobody else gets, until there are no more.
  std::optional<std::uint32_t> next_tile();
  /// To be called once a tile, when the light of its primary rays is on the film.
  void tile_is_lit();
  void add(std::span<const render::Contribution> light) { film_.add(light, alone_); }
  void traced(std::uint64_t rays) { rays_traced_.fetch_add(rays, std::memory_order_relaxed); }
  void popped(Key key);

  /// Whether the workers are to leave: somebody asked for it, or one of them failed.
  bool stopped() const {
    return failed_.load(std::memory_order_relaxed) || (stop_ != nullptr && stop_->load(std::memory_order_relaxed));
  }
  void fail(const std::string& why);
  /// To be called by each worker at its end.
  void leave();

  /// Reports to the observer until all workers have left. Either may be null.
  void watch(Observer* observer, const RayQueue* queue);

  std::string error() const;
  std::optional<std::chrono::steady_clock::time_point> first_image() const;

 private:
  using Clock = std::chrono::steady_clock;
  Progress progress(const RayQueue* queue) const;

  const render::TraceContext context_;
  render::Film& film_;
  const render::PrimaryTiles tiles_;
  const bool alone_;
  const std::atomic<bool>* const stop_;
  const Clock::time_point begin_ = Clock::now();
  std::atomic<std::uint32_t> next_tile_ = 0;
  std::atomic<std::uint32_t> tiles_lit_ = 0;
  std::atomic<std::uint64_t> rays_traced_ = 0;
  std::atomic<Key> key_ = kBuckets;  // none yet
  std::atomic<bool> failed_ = false;
  std::atomic<bool> wants_key_change_ = false;
  mutable std::mutex mutex_;  // of all below
  std::condition_variable event_;
  int workers_;
  bool key_changed_ = false;
  bool first_image_is_news_ = false;
  std::optional<Clock::time_point> first_image_;
  std::string error_;
};

}  // namespace firstlight::priority
