#pragma once

#include "priority/driver.h"
#include "priority/pass.h"
#include "priority/ray_queue.h"
#include "render/trace/radiance_bound.h"
#include "render/trace/ray_counts.h"
#include "render/trace/tracer.h"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace firstlight::priority {

/// One worker's account, of which the frame knows only now and then: numbers that all workers change would go to and
/// fro between their processors.
struct Tally {
  render::RayCounts reported;  ///< rays that the frame knows of
  std::int64_t change = 0;     ///< of what may still come, over all samples, in steps of FixedRgb; not reported
  int batches = 0;             ///< since the last report
};

/// The state that the workers share: the pass at hand, how far it all is, and when to rest or to leave.
///
/// Threads  All members may be called from any thread, but for refill().
class Frame {
 public:
  /// Pre: at least one pass.
  Frame(const render::TraceContext& context, std::span<const Pass> passes, const TraceOptions& options);

  const render::TraceContext& context() const { return context_; }
  const std::shared_ptr<const render::SurfaceTable>& surfaces() const { return surfaces_; }
  /// The roots of the pass at hand.
  RootSource& roots() const { return *stage().source; }
  /// To be called when no ray waits and none is being traced. Whether there are roots again, of this pass or of the
  /// next.
  bool refill();
  /// The samples of all passes.
  std::uint64_t samples() const { return samples_; }

  /// To be called when the light of roots is in the sink.
  void lit(const Roots& roots);
  /// Adds to the sink what a worker's tracer has found in its last step.
  void add(const render::Tracer& tracer, Tally& tally);
  /// The same for samples that no root lights, or several.
  void add_rest(const render::PrimaryBatch& rays, Tally& tally);
  /// Light will be added to the tasks' samples soon.
  void expect_light(std::span<const render::RayTask> tasks) const { stage().sink->fetch(tasks); }
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
  // As Progress has them.
  double remaining() const;
  bool remaining_is_bound() const { return bound_.known(); }
  /// The time of tracing, without pauses and checkpoints.
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct News {
    bool preview = false;
    bool first_image = false;
    bool key_changed = false;
    bool any() const { return preview || first_image || key_changed; }
  };

  /// A pass.
  struct Stage {
    RootSource* source;
    Sink* sink;
    bool is_counted;  ///< what may still come is the sum over the waiting rays; else the sink is asked
  };

  const Stage& stage() const { return stages_[stage_.load(std::memory_order_relaxed)]; }
  bool asked_to_stop() const;
  bool paused() const;
  Progress progress(const RayQueue& queue, const BlockPool& pool) const;
  bool all_rest(const RayQueue& queue) const;
  void hold_checkpoint(const Progress& progress, std::unique_lock<std::mutex>& lock);
  /// Until when to sleep before the next look at the aims. Pre: the lock is held.
  std::chrono::duration<double> look_after() const;
  void ask_sinks();
  void stop_where_aims_are_reached();
  void end_with(End end);

  const render::TraceContext context_;
  const std::shared_ptr<const render::SurfaceTable> surfaces_;
  const TraceOptions options_;
  const render::RadianceBound bound_;
  const std::int64_t most_of_root_;  // that may come of it, in steps of FixedRgb
  std::vector<Stage> stages_;
  std::vector<const Sink*> asked_;  // for what may still come, each once
  std::uint64_t samples_ = 0;
  const Clock::time_point begin_ = Clock::now();
  // Changed again and again, all that follows seldom: on lines of their own.
  alignas(64) std::atomic<Key> key_ = kBuckets;                         // none yet
  std::array<std::atomic<std::uint64_t>, render::kRayKinds> traced_{};  // by kind
  std::atomic<std::uint64_t> clear_ = 0;                                // of the feelers
  std::atomic<std::uint64_t> blocked_ = 0;                              // of the feelers, without being traced
  std::atomic<std::int64_t> remaining_ = 0;                             // over what is counted, in steps of FixedRgb
  alignas(64) int left_out_ = 0;                                        // low bits that remaining_ is without
  std::atomic<double> remaining_asked_ = 0.0;  // over the sinks that are asked; as of the last look
  std::atomic<std::size_t> stage_ = 0;
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
