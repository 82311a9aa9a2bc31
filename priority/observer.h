#pragma once

#include "priority/key.h"

#include <cstdint>

namespace firstlight::priority {

/// How far the picture is.
struct Progress {
  std::uint32_t tiles_done = 0;  ///< whose primary rays are on the film
  std::uint32_t tiles = 0;
  std::uint64_t rays_traced = 0;
  std::uint64_t rays_waiting = 0;
  Key key = 0;           ///< popped last
  double seconds = 0.0;  ///< since tracing began
};

/// Told about a picture in progress.
/// Threads  Called from the thread that called trace(), which does not trace: no worker waits for an answer.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Ten times a second.
  virtual void progress(const Progress&) {}
  /// The key that leaves the queue has changed, the paper's checkpoint; at most four times a second.
  virtual void key_changed(const Progress&) {}
  /// Every pixel has the light of its primary ray.
  virtual void first_image(const Progress&) {}
};

}  // namespace firstlight::priority
