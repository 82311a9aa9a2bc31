#pragma once

#include "priority/key.h"
#include "render/trace/ray_counts.h"

#include <cstddef>
#include <cstdint>

namespace firstlight::priority {

/// How far the picture is.
struct Progress {
  std::uint32_t tiles_done = 0;  ///< whose primary rays are on the film
  std::uint32_t tiles = 0;
  render::RayCounts traced;  ///< or known to meet nothing
  std::uint64_t rays_waiting = 0;
  std::size_t queue_bytes = 0;
  Key key = 0;                     ///< popped last
  double seconds = 0.0;            ///< since tracing began, without pauses and checkpoints
  double remaining = 0.0;          ///< mean over the pixels of the most that any channel can still change; white is 1
  bool remaining_is_bound = true;  ///< false: an estimate, because the scene has no bound
};

/// Told about a picture in progress.
/// Threads  Called from the thread that called trace(), which does not trace: no worker waits for an answer, but at a
///          checkpoint.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Ten times a second.
  virtual void progress(const Progress&) {}
  /// The key that leaves the queue has changed, the paper's checkpoint; at most four times a second.
  virtual void key_changed(const Progress&) {}
  /// The whole picture can be shown: its coarsest rays are lit, the holes between them can be filled.
  virtual void preview(const Progress&) {}
  /// Every pixel has the light of its primary ray.
  virtual void first_image(const Progress&) {}
  /// Steering::save() was called.
  virtual void save(const Progress&) {}
  /// Another TraceOptions::checkpoint_rays rays are traced. All workers rest until this returns.
  virtual void checkpoint(const Progress&) {}
};

}  // namespace firstlight::priority
