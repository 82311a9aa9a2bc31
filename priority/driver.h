#pragma once

#include "priority/observer.h"
#include "priority/scheme.h"
#include "render/film/film.h"
#include "render/trace/step.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace firstlight::priority {

struct TraceOptions {
  /// Null: the traditional order, without a queue.
  const Scheme* scheme = nullptr;
  int threads = 1;
  /// Bytes of waiting rays beyond which new ones are traced depth first at once, instead of queued. 0: no limit.
  std::size_t queue_budget = 0;
  Observer* observer = nullptr;
  /// Becomes true when somebody wants an end; the film is left as far as it is.
  const std::atomic<bool>* stop = nullptr;
};

struct TraceStatistics {
  render::RayCounts rays;
  std::uint64_t peak_rays = 0;  ///< waiting at the same time; 0 without a queue
  std::size_t peak_bytes = 0;   ///< of the blocks that held them
  double bytes_per_ray = 0.0;   ///< peak_bytes / peak_rays: part-filled blocks count, feelers of one hit share a record
  std::uint64_t worst_case_rays = 0;
  double seconds = 0.0;
  /// When every pixel had its primary ray's light; not set if it was stopped before.
  std::optional<std::chrono::steady_clock::time_point> first_image;
};

struct TraceResult {
  TraceStatistics statistics;
  bool complete = false;  ///< false: stopped, or failed
  std::string error;      ///< why it failed; else empty
};

/// Renders the whole picture into `film`, whose sums do not depend on scheme, threads or budget.
///
/// Order    primary rays first, tile by tile and never queued; then always the waiting rays of the highest key, to
/// within
///          one block a worker.
/// Threads  `options.threads` workers; the calling thread only watches.
TraceResult trace(const render::TraceContext& context, render::Film& film, const TraceOptions& options);

/// The most rays that could wait at once: m (2^(h+1) - 1) a sample for m lights (at least 1) and h levels; saturates.
/// Source   Yagel & Meeker 1997, eq. 10-12.
std::uint64_t worst_case_rays(std::uint64_t samples, std::uint64_t lights, int max_trace_level);

}  // namespace firstlight::priority
