#pragma once

#include "priority/driver.h"
#include "priority/primary_order.h"
#include "priority/ray_queue.h"
#include "render/film/film.h"
#include "render/trace/primary.h"
#include "render/trace/radiance_bound.h"
#include "render/trace/ray_counts.h"
#include "render/trace/tracer.h"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace firstlight::priority {

/// What one worker has done, of which the frame knows only now and then: numbers that all workers change would go to
/// and fro between their processors.
struct Tally {
  render::RayCounts reported;  ///< rays that the frame knows of
  std::int64_t change = 0;     ///< of what may still come, over all samples, in steps of FixedRgb; not reported
  int batches = 0;             ///< since the last report
};

/// What the workers of one picture share: the primary rays still to begin, the film, how far it all is, and when to
/// rest or to leave. Threads  All members may be called from any thread.
class Frame {
 public:
  Frame(const render::TraceContext& context, render::Film& film, const TraceOptions& options);

  const render::TraceContext& context() const { return context_; }
  const std::shared_ptr<const render::SurfaceTable>& surfaces() const { return surfaces_; }
  PrimaryOrder& primaries() { return primaries_; }

  /// To be called when the light of a batch of primary rays is on the film.
  void lit(const PrimaryOrder::Batch& batch);
  /// Adds to the film what a worker has traced; `counts` are all the rays it has traced so far.
  void add(std::span<const render::Contribution> light, const render::RayCounts& counts, Tally& tally);
  /// The same for samples that no primary ray lights.
  void add_rest(const render::PrimaryBatch& rays, Tally& tally);
  /// Light will be added to the tasks' samples soon.
  void expect_light(std::span<const render::RayTask> tasks) const {
    for (const render::RayTask& task : tasks) film_.fetch(task.sample);
  }
  /// Makes known what the tally still holds. To be called by a worker before it rests, waits or leaves.
  void report(const render::RayCounts& counts, Tally& tally);
  render::RayCounts traced() const;
  void popped(Key key);

  /// Whether the workers are to leave: somebody asked for it, an aim is reached, or one of them failed.
  bool stopped() const { return stopped_.load(std::memory_order_relaxed) || asked_to_stop(); }
  /// True from the moment on when stopped() is true for good; what an Interrupt of the workers goes by.
  const std::atomic<bool>& wish_to_end() const { return stopped_; }
  void fail(const std::string& why);
  /// To be called by a worker that leaves because of stopped(), with work left.
  void leave_unfinished() { end_with(End::stopped); }
  /// To be called by each worker at its end.
  void leave();

  /// Whether the workers are to rest: the user wants a pause, or a checkpoint is due.
  bool wants_rest() const { return checkpoint_due_.load(std::memory_order_relaxed) || paused(); }
  /// Returns when there is no more reason to.
  void rest();

  /// Reports to the observer, and stops the workers when an aim is reached, until all of them have left.
  void watch(const RayQueue& queue, const BlockPool& pool);

  End end() const;
  std::string error() const;
  std::optional<std::chrono::steady_clock::time_point> preview() const;
  std::optional<std::chrono::steady_clock::time_point> first_image() const;
  /// As Progress::remaining.
  double remaining() const;
  /// Of tracing, without pauses and checkpoints.
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct News {
    bool preview = false;
    bool first_image = false;
    bool key_changed = false;
    bool any() const { return preview || first_image || key_changed; }
  };

  bool asked_to_stop() const;
  bool paused() const;
  Progress progress(const RayQueue& queue, const BlockPool& pool) const;
  bool all_rest(const RayQueue& queue) const;
  void hold_checkpoint(const Progress& progress, std::unique_lock<std::mutex>& lock);
  /// Until when to sleep before the next look at the aims. Pre: the lock is held.
  std::chrono::duration<double> look_after() const;
  void look_at_refinement();
  void stop_where_aims_are_reached();
  void end_with(End end);

  const render::TraceContext context_;
  const std::shared_ptr<const render::SurfaceTable> surfaces_;
  render::Film& film_;
  const TraceOptions options_;
  const render::RadianceBound bound_;
  PrimaryOrder primaries_;
  const Clock::time_point begin_ = Clock::now();
  // Changed again and again, all that follows seldom: on lines of their own.
  alignas(64) std::atomic<std::uint32_t> tiles_lit_ = 0;
  std::atomic<std::uint32_t> coarse_tiles_lit_ = 0;
  std::atomic<Key> key_ = kBuckets;                                     // none yet
  std::array<std::atomic<std::uint64_t>, render::kRayKinds> traced_{};  // by kind
  std::atomic<std::uint64_t> clear_ = 0;                                // of the feelers
  std::atomic<std::uint64_t> blocked_ = 0;                              // of the feelers, without being traced
  std::atomic<std::int64_t> remaining_ = 0;                             // over all pixels, in steps of FixedRgb
  alignas(64) int left_out_ = 0;                                        // low bits that remaining_ is without
  std::atomic<double> refinement_remaining_ = 0.0;  // over all pixels, with anti-aliasing; as of the last look
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> wants_key_change_ = false;
  std::atomic<bool> checkpoint_due_ = false;
  std::atomic<std::uint64_t> next_checkpoint_;
  mutable std::mutex mutex_;  // of all below
  std::condition_variable event_;
  std::condition_variable go_on_;
  int workers_;
  int resting_ = 0;
  News news_;
  Clock::duration rested_{};
  std::optional<Clock::time_point> preview_;
  std::optional<Clock::time_point> first_image_;
  End end_ = End::complete;
  std::string error_;
};

}  // namespace firstlight::priority
