#pragma once

#include "priority/block_pool.h"
#include "priority/observer.h"
#include "priority/pass.h"
#include "priority/ray_queue.h"
#include "priority/scheme.h"
#include "render/film/antialias.h"
#include "render/film/film.h"
#include "render/trace/ray_counts.h"
#include "render/trace/ray_task.h"
#include "render/trace/trace_context.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace firstlight::priority {

class Steering;

/// Less than this is no queue.
constexpr std::size_t kSmallestQueueMemory = 64 * BlockPool::kSmallestBlock * sizeof(render::RayTask);

struct TraceOptions {
  /// Null: the traditional order, without a queue.
  const Scheme* scheme = nullptr;
  /// Where a user changes the order and more while it renders; its scheme is used instead of the one above. May be
  /// null.
  Steering* steering = nullptr;
  int threads = 1;
  /// Bytes that waiting rays may take. Near them no new primary rays are begun, beyond them rays are traced depth first
  /// at once instead of queued. 0: no limit.
  std::size_t queue_memory = 0;
  /// Rays in a full block; 0: as many as suit the memory.
  std::uint32_t block_size = 0;
  /// Extra samples of pictures, where contrast asks for them; null: none.
  const render::AntialiasSettings* antialias = nullptr;
  Observer* observer = nullptr;
  /// Rays between two checkpoints; 0: no checkpoints.
  std::uint64_t checkpoint_rays = 0;
  /// Becomes true when somebody wants an end; the film is left as far as it is.
  const std::atomic<bool>* stop = nullptr;
  /// Ends when Progress::remaining is not larger; 0: only when nothing is left.
  double stop_at_error = 0.0;
  /// Ends after so many seconds of tracing; 0: never.
  double stop_after = 0.0;
};

struct TraceStatistics {
  render::RayCounts rays;
  std::uint64_t peak_rays = 0;  ///< waiting at the same time; 0 without a queue
  std::size_t peak_bytes = 0;   ///< of the blocks that held them
  double bytes_per_ray = 0.0;   ///< peak_bytes / peak_rays: part-filled blocks count, feelers of one hit share a record
  std::uint64_t worst_case_rays = 0;
  /// Rays traced while a more important one lay in another worker's open blocks.
  std::uint64_t inverted_rays = 0;
  RayQueue::Rekeying rekeying;
  double seconds = 0.0;            ///< without pauses and checkpoints
  double remaining = 0.0;          ///< as Progress::remaining, at the end
  bool remaining_is_bound = true;  ///< likewise
  /// When the whole picture could be shown, with holes filled; not set if it was stopped before, as is the next.
  std::optional<std::chrono::steady_clock::time_point> preview;
  /// When every pixel had its primary ray's light.
  std::optional<std::chrono::steady_clock::time_point> first_image;
};

/// Why tracing ended.
enum class End { complete, stopped, error_reached, time_over, failed };

struct TraceResult {
  TraceStatistics statistics;
  End end = End::failed;
  std::string error;  ///< why it failed; else empty

  bool complete() const { return end == End::complete; }
};

/// Traces the passes one after the other, with one queue, one progress and one steering. What the sinks sum up does not
/// depend on scheme, threads, steering or memory.
///
/// Order    always the rays of the highest key, to within one block a worker; roots are made when their turn comes. A
///          pass begins when those before it are complete.
/// Threads  `options.threads` workers; the calling thread only watches.
TraceResult trace(const render::TraceContext& context, std::span<const Pass> passes, const TraceOptions& options);
/// Renders a whole picture into `film`: primary rays from a coarse grid to the finest, then anti-aliasing.
TraceResult trace(const render::TraceContext& context, render::Film& film, const TraceOptions& options);

/// The most rays that could wait at once: m (2^(h+1) - 1) a sample for m lights (at least 1) and h levels; saturates.
/// Source   Yagel & Meeker 1997, eq. 10-12.
std::uint64_t worst_case_rays(std::uint64_t samples, std::uint64_t lights, int max_trace_level);

}  // namespace firstlight::priority
