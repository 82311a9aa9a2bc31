#pragma once

#include "priority/scheme.h"
#include "priority/slot.h"
#include "render/trace/primary.h"

#include <cstddef>
#include <cstdint>

namespace firstlight::priority {

/// Rays with which trees begin, that begin together.
struct Roots {
  render::PrimaryBatch rays;
  std::uint32_t number = 0;  ///< the source's own, to know them again
};

/// Where trees of rays begin: tiles of the picture, rounds of anti-aliasing. Roots are made when a worker asks, so they
/// take no memory while they wait.
///
/// Order    A source may have roots from the start. When none of them is left and no ray waits, refill() begins the next
///          round, which may depend on all that the rounds before brought.
/// Threads  refill(): one thread, while no other works. The rest: any thread.
class RootSource {
 public:
  virtual ~RootSource() = default;

  /// The slot of the most important roots that have not begun; kNoSlot: all of the round have.
  virtual int top() const = 0;
  /// Replaces `roots` by the next ones for `worker`. False: all of the round have begun.
  virtual bool next(std::size_t worker, Roots& roots) = 0;
  /// Whether there is another round.
  virtual bool refill() { return false; }
  /// Puts what has not begun in the scheme's order; a version that was seen before changes nothing.
  virtual void sort(const Scheme& /*scheme*/, std::uint64_t /*version*/) {}

  /// The stages of a picture that may be reached for the first time.
  struct Reached {
    bool preview = false;      ///< the whole picture, with holes filled
    bool first_image = false;  ///< the light of every pixel's primary ray
  };
  /// To be called once for all roots of a next(), when their own light is in the sink.
  virtual Reached lit(const Roots& /*roots*/) { return {}; }

  struct Extent {
    std::uint32_t lit = 0;
    std::uint32_t all = 0;
  };
  /// In calls of next(), for progress; none where nobody can say how many there will be.
  virtual Extent extent() const { return {}; }
};

}  // namespace firstlight::priority
